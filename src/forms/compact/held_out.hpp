#pragma once

#include <nlohmann/json.hpp>

#include "skylut/models/sky_model.hpp"
#include "skylut/sky/sky_scene.hpp"

namespace skylut {
struct Context;
}

namespace skylut::compact {

/// What a model errs at conditions that it was not made from: a low-discrepancy set over its domain, in
/// directions even in solid angle from the zenith to the geometric horizon, no nearer to the sun than 0.5°,
/// against lines of sight through every band of the scene. By sun's zenith angle: root mean square relative
/// error of luminance and of x and y, median and worst sky; and of all directions' luminance the 99th
/// percentile of size.
/// @param conditions  how many skies
nlohmann::ordered_json held_out_error(const Context& context, const SkyScene& scene, const SkyModel& model,
                                      std::size_t conditions, const TransferOptions& options);

}  // namespace skylut::compact
