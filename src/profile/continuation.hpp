#pragma once

#include "skylut/profile/profile.hpp"

namespace skylut {

/// Continues a profile that ends below 100 km with the levels of the standard above its end: the standard's
/// temperature, its pressure scaled to join at the last level, oxygen and carbon dioxide as at the last
/// level's part of the air. The other gases are the standard's, scaled to join at the last level; from an end
/// below 30 km, which says little of what is further above, the scale falls back to 1 within 5 km. Aerosol
/// ends at the next level.
void continue_to_top(Profile& profile, const Profile& standard);

}  // namespace skylut
