#pragma once

#include "profile_file.hpp"
#include "skylut/profile/profile.hpp"

namespace skylut {

/// Table 3.1's quantities at the described levels from the profile itself: T_eo is the mean temperature
/// of the ozone above the level, relative humidity the vapour's pressure over eq. 3.9, precipitable
/// water and ozone the columns above. Oxygen and carbon dioxide paths by eq. 3.11.
std::vector<LevelQuantities> physical_quantities(const Profile& profile);

/// The same as the report has them: T_eo by eq. 3.7, ozone by eq. 3.12, humidity and water as printed.
std::vector<LevelQuantities> report_quantities(const Profile& profile, const Report2005& report);

}  // namespace skylut
