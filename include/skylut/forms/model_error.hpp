#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "skylut/forms/sky_supply.hpp"

namespace skylut {

/// How far a model is from one sky.
struct SkyError {
  SoughtSky conditions;
  double rms_Y_rel = 0.0;   ///< by solid angle, of (Y - Y_sky)/Y_sky
  double mean_Y_rel = 0.0;  ///< their mean
  double rms_x = 0.0;       ///< by solid angle
  double rms_y = 0.0;
  double worst_Y_rel = 0.0;  ///< signed, the largest in size
  Direction worst_view;
};

/// A model against skies. @throws InputError  as the model's at()
std::vector<SkyError> sky_errors(const SkyModel& model, std::span<const TrainingSky> skies);

/// Median, 90th percentile and worst of the skies, and where the worst is.
nlohmann::ordered_json error_summary(std::span<const SkyError> errors);

/// Conditions spread evenly over a domain: `loads` turbidities and albedos, each with `per_load` altitudes
/// and suns; the same for the same domain. Even in the number of the node between nodes that a supply has,
/// else in value. No albedo where the domain has none.
std::vector<SoughtSky> spread_conditions(const ModelInfo& domain, const SkyAxes& axes, int loads,
                                         int per_load);

}  // namespace skylut
