#pragma once

#include <nlohmann/json_fwd.hpp>

#include "skylut/profile/profile.hpp"

namespace skylut {

/// A profile as it stands, level by level in full precision: enough to make it again without its file.
nlohmann::ordered_json profile_json(const Profile& profile);

}  // namespace skylut
