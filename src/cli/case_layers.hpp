#pragma once

#include <vector>

#include "json_reader.hpp"
#include "skylut/optics/optical_state.hpp"

namespace skylut::cli {

/// Reads `layers` into a column, in the order of the file. A layer has either the keys tau_rayleigh,
/// tau_aerosol, ssa_aerosol, g_aerosol, tau_absorption or the keys tau, ssa and one of
/// phase_moments and g_hg. One scatterer per distinct phase function.
/// @throws InputError  naming the layer and the key
OpticalColumn read_layers(const std::vector<JsonReader>& layers);

/// Turns the order of the layers round.
void reverse_layers(OpticalColumn& column);

}  // namespace skylut::cli
