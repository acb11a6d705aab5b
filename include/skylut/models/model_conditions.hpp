#pragma once

#include "skylut/models/sky_model.hpp"

namespace skylut {

/// @throws InputError  naming what, its value and what would be right, unless the conditions lie within what
///                     the model was fitted to
void require_within_domain(const ModelInfo& info, const SkyConditions& conditions);

/// @throws InputError  unless there are as many views as answers, each within the model's domain
void require_views(const ModelInfo& info, std::span<const Direction> views, std::size_t answers);

}  // namespace skylut
