#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "skylut/atmosphere/atmosphere.hpp"

namespace skylut {

/// A profile in readable columns: what it is, Table 3.1's quantities, the levels, the columns of the
/// gases, optical depths at 550 nm by constituent and by layer, and the turbidity in all kinds.
std::string profile_text(const Atmosphere& air, double aod500);

/// The same, complete and in full precision.
nlohmann::ordered_json profile_json(const Atmosphere& air, double aod500);

}  // namespace skylut
