#pragma once

#include "skylut/profile/profile.hpp"

namespace skylut {

/// Altitude that every profile reaches.
inline constexpr double kAtmosphereTop_km = 100.0;

/// Continues a profile that ends below 100 km with the levels of the standard above its end: the
/// standard's temperature, and its pressure and gases scaled to join at the last level. Aerosol ends
/// at the next level.
void continue_to_top(Profile& profile, const Profile& standard);

}  // namespace skylut
