#pragma once

#include <string>
#include <vector>

#include "skylut/models/sky_model.hpp"

namespace skylut {

/// What of the conditions lies outside the domain that a model states, each with the domain: "altitude 31 km
/// (0 to 30 km)". Empty: all within. The turbidity is taken to be of the model's kind; the albedo counts only
/// where the model has one.
std::vector<std::string> outside_domain(const ModelInfo& info, const SkyConditions& conditions);

}  // namespace skylut
