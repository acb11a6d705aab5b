#include "held_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "grey_columns.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/low_discrepancy.hpp"
#include "skylut/core/parallel.hpp"
#include "skylut/transfer/solved_columns.hpp"

namespace skylut::compact {

namespace {

constexpr std::size_t kViews = 48;
constexpr double kFromSun_deg = 0.5;

/// Classes of the sun's zenith angle that errors are stated for.
struct SunClass {
  const char* name;
  double lowest_deg;
  double highest_deg;
};
constexpr SunClass kClasses[] = {
    {"sun_0_90", 0.0, 90.0}, {"sun_90_92", 90.0, 92.0}, {"sun_92_96", 92.0, 96.0}};

double within(const Range& range, double share) {
  return range.lowest + share * (range.highest - range.lowest);
}

/// Every other sky has its sun in the last tenth of the range, where skies change most; every fourth haze is
/// thin and every fourth observer low.
SkyConditions conditions_of(const ModelInfo& info, std::size_t i) {
  const double altitude = low_discrepancy(i + 1, 2);
  const double load = low_discrepancy(i + 1, 3);
  const double sun = low_discrepancy(i + 1, 5);
  const double near_horizon_deg = std::max(info.sun_zenith_deg.lowest, 86.0);
  SkyConditions conditions;
  conditions.altitude_km = within(info.altitude_km, i % 4 == 1 ? 0.1 * altitude : altitude);
  conditions.turbidity = {info.turbidity_kind, within(info.turbidity, i % 4 == 3 ? 0.1 * load : load)};
  conditions.albedo = within(*info.albedo, low_discrepancy(i + 1, 7));
  conditions.sun = {i % 2 == 0 ? within(info.sun_zenith_deg, sun)
                               : near_horizon_deg + sun * (info.sun_zenith_deg.highest - near_horizon_deg),
                    0.0};
  return conditions;
}

std::vector<Direction> views_of(const SkyConditions& conditions, double planet_radius_km) {
  const double cos_horizon =
      -std::sqrt(1.0 - std::pow(planet_radius_km / (planet_radius_km + conditions.altitude_km), 2.0));
  std::vector<Direction> views;
  for (std::size_t i = 0; views.size() < kViews; ++i) {
    const double cosine = 1.0 + low_discrepancy(i + 1, 2) * (cos_horizon - 1.0);
    const Direction view{std::acos(cosine) * kDegreesPerRadian, 180.0 * low_discrepancy(i + 1, 3)};
    if (angle_between(view, conditions.sun) > kFromSun_deg * kRadiansPerDegree) views.push_back(view);
  }
  return views;
}

/// Lines of sight through all bands.
class Reference {
 public:
  Reference(const Context& context, const SkyScene& scene, const TransferOptions& options)
      : context_(context),
        scene_(scene),
        options_(options),
        irradiance_(extraterrestrial_irradiance(context, scene)),
        colour_(ColourMatching::load(context).weights(scene.wavelengths)) {}

  std::vector<Yxy> colours(const SkyConditions& conditions, const std::vector<Direction>& views) const {
    GreyColumns bands = grey_columns(scene_, conditions.turbidity.value, conditions.albedo);
    std::vector<Xyz> weights;
    for (std::size_t column = 0; column < bands.columns.size(); ++column) {
      const std::size_t i = bands.band[column];
      const double weight = bands.weight[column] * irradiance_[i];
      weights.push_back({weight * colour_[i].X, weight * colour_[i].Y, weight * colour_[i].Z});
    }
    const std::array sun_deg{conditions.sun.zenith_deg};
    const SolvedColumns sky(context_, scene_.atmosphere->shells(), std::move(bands.columns), sun_deg,
                            options_);
    std::vector<Yxy> colours(views.size());
    parallel_for(views.size(), context_.threads, [&](std::size_t i) {
      const std::array azimuth_deg{views[i].azimuth_deg};
      std::vector<float> radiance(sky.columns());
      sky.radiance({conditions.altitude_km, views[i].zenith_deg, conditions.sun.zenith_deg, azimuth_deg},
                   radiance);
      colours[i] = to_yxy(weighted_sum<float>(weights, radiance));
    });
    return colours;
  }

 private:
  const Context& context_;
  const SkyScene& scene_;
  const TransferOptions& options_;
  std::vector<double> irradiance_;
  std::vector<Xyz> colour_;
};

struct SkyError {
  double sun_deg = 0.0;
  double rms_Y = 0.0;
  double rms_x = 0.0;
  double rms_y = 0.0;
  std::vector<double> each_Y;
};

SkyError error_of(const SkyModel& model, const Reference& reference, const SkyConditions& conditions,
                  double planet_radius_km) {
  const std::vector<Direction> views = views_of(conditions, planet_radius_km);
  const std::vector<Yxy> exact = reference.colours(conditions, views);
  std::vector<Yxy> found(views.size());
  model.at(conditions)->colour(views, found);
  SkyError error{.sun_deg = conditions.sun.zenith_deg, .each_Y = {}};
  for (std::size_t i = 0; i < views.size(); ++i) {
    const double relative = found[i].Y / exact[i].Y - 1.0;
    error.each_Y.push_back(std::abs(relative));
    error.rms_Y += relative * relative;
    error.rms_x += std::pow(found[i].x - exact[i].x, 2.0);
    error.rms_y += std::pow(found[i].y - exact[i].y, 2.0);
  }
  for (double* sum : {&error.rms_Y, &error.rms_x, &error.rms_y})
    *sum = std::sqrt(*sum / static_cast<double>(views.size()));
  return error;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

nlohmann::ordered_json class_json(const std::vector<SkyError>& errors, const SunClass& of) {
  std::vector<double> rms;
  std::vector<double> each;
  double worst_xy = 0.0;
  for (const SkyError& error : errors) {
    if (error.sun_deg < of.lowest_deg || error.sun_deg >= of.highest_deg) continue;
    rms.push_back(error.rms_Y);
    each.insert(each.end(), error.each_Y.begin(), error.each_Y.end());
    worst_xy = std::max({worst_xy, error.rms_x, error.rms_y});
  }
  nlohmann::ordered_json json;
  json["skies"] = rms.size();
  if (rms.empty()) return json;
  json["rms_Y_rel_median"] = quantile(rms, 0.5);
  json["rms_Y_rel_worst"] = quantile(rms, 1.0);
  json["direction_Y_rel_p99"] = quantile(each, 0.99);
  json["rms_xy_worst"] = worst_xy;
  return json;
}

}  // namespace

nlohmann::ordered_json held_out_error(const Context& context, const SkyScene& scene, const SkyModel& model,
                                      std::size_t conditions, const TransferOptions& options) {
  const Reference reference(context, scene, options);
  std::vector<SkyError> errors;
  for (std::size_t i = 0; i < conditions; ++i) {
    if (context.progress) context.progress("measuring the model", i, conditions);
    if (context.cancel.stop_requested()) throw Cancelled();
    errors.push_back(error_of(model, reference, conditions_of(model.info(), i),
                              scene.atmosphere->shells().planet_radius_km));
  }
  nlohmann::ordered_json json;
  json["measured"] = "at held-out conditions, against lines of sight";
  for (const SunClass& of : kClasses) json[of.name] = class_json(errors, of);
  return json;
}

}  // namespace skylut::compact
