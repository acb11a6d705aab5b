#pragma once

#include <vector>

#include "skylut/core/json_reader.hpp"
#include "skylut/scattering/optical_column.hpp"

namespace skylut {

/// Reads `layers` into a column, in the order of the file. A layer has either the keys tau_rayleigh,
/// tau_aerosol, ssa_aerosol, g_aerosol, tau_absorption and, if there is any, one of
/// phase_moments_aerosol, phase_matrix_aerosol and matrix_moments_aerosol, which then stands instead of
/// g_aerosol; or the keys tau, ssa and one of phase_moments, g_hg, phase_matrix and matrix_moments. One
/// scatterer per distinct phase function.
/// @param rayleigh_depolarisation  of tau_rayleigh, [0, 0.5]
/// @throws InputError  naming the layer and the key
OpticalColumn read_layers(const std::vector<JsonReader>& layers, double rayleigh_depolarisation = 0.0);

/// Turns the order of the layers round.
void reverse_layers(OpticalColumn& column);

}  // namespace skylut
