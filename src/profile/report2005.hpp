#pragma once

#include <vector>

#include "skylut/profile/profile.hpp"

namespace skylut {

/// Table 3.1 of the report's own profile, at the described levels: T_eo by eq. 3.7, ozone by eq. 3.12,
/// humidity and water as printed.
std::vector<LevelQuantities> report_quantities(const Profile& profile, const Report2005& report);

}  // namespace skylut
