#include "skylut/table/between_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "skylut/core/check.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kCloseFactor = 1.2;
constexpr double kCloseAbove = 0.01;

// The digits of i in a base, mirrored at the point: evenly spread over [0, 1) (Halton 1960).
double halton(std::size_t i, std::size_t base) {
  double fraction = 1.0;
  double value = 0.0;
  for (; i > 0; i /= base) {
    fraction /= static_cast<double>(base);
    value += fraction * static_cast<double>(i % base);
  }
  return value;
}

double within(const Range& range, double part) {
  return range.lowest + part * (range.highest - range.lowest);
}

Yxy rms_of(const Sky& sky, const HeldOutSky& truth) {
  std::vector<Yxy> colours(truth.directions.size());
  sky.colour(truth.directions, colours);
  Yxy squares;
  double all = 0.0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double weight = truth.solid_angles[i];
    const double Y = colours[i].Y / truth.colours[i].Y - 1.0;
    const double x = colours[i].x - truth.colours[i].x;
    const double y = colours[i].y - truth.colours[i].y;
    squares.Y += weight * Y * Y;
    squares.x += weight * x * x;
    squares.y += weight * y * y;
    all += weight;
  }
  return {std::sqrt(squares.Y / all), std::sqrt(squares.x / all), std::sqrt(squares.y / all)};
}

ErrorSpread spread_of(const std::vector<Yxy>& errors, double Yxy::*channel) {
  std::vector<double> values;
  for (const Yxy& error : errors) values.push_back(error.*channel);
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) {
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(part * static_cast<double>(values.size())))];
  };
  return {at(0.5), at(0.9), values.back()};
}

Json json_of(const ErrorSpread& spread) {
  return {{"median", spread.median}, {"p90", spread.p90}, {"worst", spread.worst}};
}

}  // namespace

std::vector<SkyConditions> held_out_conditions(const Range& altitude_km, TurbidityKind kind,
                                               const Range& turbidity, const Range& sun_zenith_deg,
                                               std::size_t loads, std::size_t skies_per_load) {
  std::vector<SkyConditions> all;
  for (std::size_t load = 0; load < loads; ++load)
    for (std::size_t i = 0; i < skies_per_load; ++i) {
      const std::size_t sky = load * skies_per_load + i + 1;
      SkyConditions conditions;
      conditions.turbidity = {kind, within(turbidity, halton(load + 1, 2))};
      conditions.altitude_km = within(altitude_km, halton(sky, 3));
      conditions.sun = {within(sun_zenith_deg, halton(sky, 5)), 0.0};
      all.push_back(conditions);
    }
  return all;
}

BetweenNodesError between_nodes_error(const TableModel& table, std::span<const HeldOutSky> skies) {
  SKYLUT_CHECK_GE(skies.size(), 1U);
  BetweenNodesError error;
  error.skies = skies.size();
  std::vector<Yxy> of_table;
  std::vector<Yxy> of_row;
  double worst = -1.0;
  for (const HeldOutSky& sky : skies) {
    const SkyConditions conditions{.altitude_km = sky.alone.altitude_km,
                                   .turbidity = {table.info().turbidity_kind, sky.alone.turbidity},
                                   .sun = sky.alone.sun};
    of_table.push_back(rms_of(*table.at(conditions), sky));
    of_row.push_back(rms_of(sky_of(sky.alone), sky));
    if (of_table.back().Y <= kCloseFactor * of_row.back().Y + kCloseAbove) ++error.close;
    if (of_table.back().Y <= worst) continue;
    worst = of_table.back().Y;
    error.worst_of_Y = conditions;
  }
  error.Y = spread_of(of_table, &Yxy::Y);
  error.x = spread_of(of_table, &Yxy::x);
  error.y = spread_of(of_table, &Yxy::y);
  error.Y_alone = spread_of(of_row, &Yxy::Y);
  error.x_alone = spread_of(of_row, &Yxy::x);
  error.y_alone = spread_of(of_row, &Yxy::y);
  return error;
}

Json between_nodes_json(const BetweenNodesError& error) {
  Json json;
  json["what"] =
      "root mean square by solid angle over the dome, at conditions between the rows against simulations; Y "
      "relative, x and y absolute; row_alone: of a row fitted at those very conditions";
  json["skies"] = error.skies;
  json["sun_zenith_to_deg"] = error.sun_zenith_to_deg;
  json["table"] = {{"Y", json_of(error.Y)}, {"x", json_of(error.x)}, {"y", json_of(error.y)}};
  json["row_alone"] = {
      {"Y", json_of(error.Y_alone)}, {"x", json_of(error.x_alone)}, {"y", json_of(error.y_alone)}};
  json["within_1.2_times_row_alone_plus_0.01"] = error.close;
  json["worst_Y_at"] = {{"altitude_km", error.worst_of_Y.altitude_km},
                        {"turbidity", error.worst_of_Y.turbidity.value},
                        {"sun_zenith_deg", error.worst_of_Y.sun.zenith_deg}};
  return json;
}

}  // namespace skylut
