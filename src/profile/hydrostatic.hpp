#pragma once

#include <string>
#include <vector>

#include "skylut/profile/profile.hpp"

namespace skylut {

/// Largest part of the air's column by which ∫ p/(kT) dz from the ground differs from the weight of that air,
/// ∫ -dp/(m g), at any level: 0 for hydrostatic air. g falls with the square of the distance from the
/// Earth's centre, m is that of air with the profile's water vapour.
/// @param ground_height_km  above sea level, of altitude 0
double hydrostatic_mismatch(const Profile& profile, double ground_height_km);

/// Lets the weight of the air fix its column where the two differ by more than 0.3 %: few levels know too
/// little of the temperature between them. In every piece whose pressures and temperatures contradict each
/// other levels are added, at most 1 km apart, whose temperature is the straight line times
/// exp(-c 4t(1-t)), t from 0 to 1 over the piece, with the c that makes the pressure fall as the file says
/// (hypsometric equation). Temperature and pressure at the file's own levels stay. Says so in the profile's
/// notes. Pieces thicker than 2.5 km below 30 km get such levels in any case, so that gases keep their part
/// of the air between them. [docs/air.md A54]
/// @param mixing_ratio_gases  keep their mole fraction (its logarithm linear in altitude) between levels;
///                            other gases the logarithm of their density
/// @throws InputError  naming the two levels where pressures and temperatures are a factor of 2 apart
void balance(Profile& profile, double ground_height_km, const std::vector<std::string>& mixing_ratio_gases,
             const std::string& path);

}  // namespace skylut
