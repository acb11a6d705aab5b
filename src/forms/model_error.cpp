#include "skylut/forms/model_error.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

SkyConditions conditions_of(const SoughtSky& request) {
  return {request.altitude_km, request.turbidity, request.albedo.value_or(SkyConditions{}.albedo),
          request.sun};
}

SkyError error_of(const SkyModel& model, const TrainingSky& sky) {
  const std::unique_ptr<const Sky> modelled = model.at(conditions_of(sky.conditions));
  std::vector<Yxy> colours(sky.colours.size());
  modelled->colour(sky.dome.views, colours);
  SkyError error;
  error.conditions = sky.conditions;
  double all = 0.0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double weight = sky.dome.solid_angle[i];
    const double off = (colours[i].Y - sky.colours[i].Y) / sky.colours[i].Y;
    all += weight;
    error.rms_Y_rel += weight * off * off;
    error.mean_Y_rel += weight * off;
    error.rms_x += weight * std::pow(colours[i].x - sky.colours[i].x, 2);
    error.rms_y += weight * std::pow(colours[i].y - sky.colours[i].y, 2);
    if (std::abs(off) <= std::abs(error.worst_Y_rel)) continue;
    error.worst_Y_rel = off;
    error.worst_view = sky.dome.views[i];
  }
  error.mean_Y_rel /= all;
  for (double* mean : {&error.rms_Y_rel, &error.rms_x, &error.rms_y}) *mean = std::sqrt(*mean / all);
  return error;
}

// In four digits: it is a measurement.
double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

template <class Value>
ordered_json distribution(std::span<const SkyError> errors, const Value& value) {
  std::vector<double> values;
  for (const SkyError& error : errors) values.push_back(std::abs(value(error)));
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values[static_cast<std::size_t>(std::ceil(part * static_cast<double>(values.size()))) - 1];
  };
  return {{"median", rounded(at(0.5))}, {"p90", rounded(at(0.9))}, {"worst", rounded(values.back())}};
}

/// The fractional parts of multiples of the powers of the root of x⁶ = x + 1: points that fill a cube of up
/// to five dimensions evenly. [Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"]
double spread(int index, int dimension) {
  constexpr double kRoot = 1.1347241384015194;
  const double value = 0.5 + (index + 1) * std::pow(kRoot, -(dimension + 1));
  return value - std::floor(value);
}

double between(const Range& range, const std::vector<double>& nodes, double part) {
  std::vector<double> inside{range.lowest};
  for (const double node : nodes)
    if (node > range.lowest && node < range.highest) inside.push_back(node);
  inside.push_back(range.highest);
  const double place = part * static_cast<double>(inside.size() - 1);
  const std::size_t piece = std::min(static_cast<std::size_t>(place), inside.size() - 2);
  return inside[piece] + (place - static_cast<double>(piece)) * (inside[piece + 1] - inside[piece]);
}

}  // namespace

std::vector<SkyError> sky_errors(const SkyModel& model, std::span<const TrainingSky> skies) {
  std::vector<SkyError> errors;
  for (const TrainingSky& sky : skies) errors.push_back(error_of(model, sky));
  return errors;
}

ordered_json error_summary(std::span<const SkyError> errors) {
  if (errors.empty()) return {};
  const auto worst = std::max_element(errors.begin(), errors.end(), [](const SkyError& a, const SkyError& b) {
    return a.rms_Y_rel < b.rms_Y_rel;
  });
  ordered_json at{{"altitude_km", worst->conditions.altitude_km},
                  {"turbidity", worst->conditions.turbidity.value},
                  {"sun_zenith_deg", worst->conditions.sun.zenith_deg}};
  if (worst->conditions.albedo) at["albedo"] = *worst->conditions.albedo;
  return {{"skies", errors.size()},
          {"rms_Y_rel", distribution(errors, [](const SkyError& e) { return e.rms_Y_rel; })},
          {"rms_x", distribution(errors, [](const SkyError& e) { return e.rms_x; })},
          {"rms_y", distribution(errors, [](const SkyError& e) { return e.rms_y; })},
          {"worst_direction_Y_rel", distribution(errors, [](const SkyError& e) { return e.worst_Y_rel; })},
          {"worst_sky", at}};
}

std::vector<SoughtSky> spread_conditions(const ModelInfo& domain, const SkyAxes& axes, int loads,
                                         int per_load) {
  std::vector<SoughtSky> requests;
  const bool same_kind = domain.turbidity_kind == axes.turbidity_kind;
  for (int load = 0; load < loads; ++load) {
    SoughtSky request;
    request.turbidity = {
        domain.turbidity_kind,
        between(domain.turbidity, same_kind ? axes.turbidities : std::vector<double>{}, spread(load, 0))};
    if (domain.albedo) request.albedo = between(*domain.albedo, {}, spread(load, 1));
    for (int i = 0; i < per_load; ++i) {
      const int index = load * per_load + i;
      request.altitude_km = between(domain.altitude_km, axes.altitudes_km, spread(index, 2));
      request.sun = {between(domain.sun_zenith_deg, {}, spread(index, 3)), 0.0};
      requests.push_back(request);
    }
  }
  return requests;
}

}  // namespace skylut
