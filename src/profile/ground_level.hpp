#pragma once

#include "skylut/profile/profile.hpp"

namespace skylut {

/// The part of a profile above an altitude of it, counted from there, to 100 km at the least. The lowest
/// piece goes on below the first level, the last one isothermally above the last.
Profile with_ground_at(const Profile& profile, double altitude_km);

}  // namespace skylut
