#pragma once

#include <optional>
#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut {

/// Slant path of the sun's beam through each layer, in units of the layer's thickness, on its way to an
/// observer through spherical shells: straight, or bent where they have a refractivity. 1/cos z in flat
/// layers that lie above the observer, 0 in those that the beam does not cross. From a height the sun can be
/// seen below the horizontal: the beam then crosses the layers beneath it twice. [theory.md §4.1, G4;
/// docs/refraction.md §2]
/// @param altitude_km     of the observer above the ground, [0, top level]
/// @param sun_zenith_deg  true, at the observer's vertical, [0, 180]
/// @return  one factor per layer, bottom to top; nothing where the ground hides the sun
/// @throws InputError  for values out of range
std::optional<std::vector<double>> beam_path_factors(const Shells& shells, double altitude_km,
                                                     double sun_zenith_deg);

/// The same along a line of sight of an APPARENT zenith angle. @return nothing where it meets the ground
std::optional<std::vector<double>> sight_path_factors(const Shells& shells, double altitude_km,
                                                      double view_zenith_deg);

/// T = exp(-Σ depth · factor) (Beer, Lambert). @param depth  vertical optical depth per layer, >= 0
/// @throws InputError  for lists of unequal length
double beam_transmittance(const std::vector<double>& path_factors, const std::vector<double>& depth);

}  // namespace skylut
