#pragma once

#include <vector>

#include "skylut/atmosphere/atmosphere.hpp"

namespace skylut {

/// What one constituent lets through of a band, [0, 1]: Σ weight exp(-Σ depth · factor).
/// @param path_factors  as beam_path_factors gives them
double band_transmittance(const ConstituentExtinction& constituent, const std::vector<double>& path_factors);

}  // namespace skylut
