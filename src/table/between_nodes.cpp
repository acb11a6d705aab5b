#include "skylut/table/between_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "skylut/core/check.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kCloseFactor = 1.2;
constexpr double kCloseAbove = 0.01;
constexpr double kHorizon_deg = 90.0;

Yxy rms_of(const Sky& sky, const HeldOutSky& truth) {
  std::vector<Yxy> colours(truth.directions.size());
  sky.colour(truth.directions, colours);
  Yxy squares;
  double all = 0.0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double weight = truth.solid_angles_sr[i];
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

Json json_of(const BetweenNodesError& error) {
  return {{"skies", error.skies},
          {"table", {{"Y", json_of(error.Y)}, {"x", json_of(error.x)}, {"y", json_of(error.y)}}},
          {"row_alone",
           {{"Y", json_of(error.Y_alone)}, {"x", json_of(error.x_alone)}, {"y", json_of(error.y_alone)}}},
          {"within_1.2_times_row_alone_plus_0.01", error.close},
          {"worst_Y_at",
           {{"altitude_km", error.worst_of_Y.altitude_km},
            {"turbidity", error.worst_of_Y.turbidity.value},
            {"sun_zenith_deg", error.worst_of_Y.sun.zenith_deg}}}};
}

}  // namespace

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

Json between_nodes_json(const TableModel& table, std::span<const HeldOutSky> skies) {
  std::vector<HeldOutSky> by_day;
  std::vector<HeldOutSky> in_twilight;
  for (const HeldOutSky& sky : skies)
    (sky.alone.sun.zenith_deg <= kHorizon_deg ? by_day : in_twilight).push_back(sky);
  Json json;
  json["what"] =
      "root mean square by solid angle over the dome, at conditions between the rows against simulations; Y "
      "relative, x and y absolute; row_alone: of a row fitted at those very conditions";
  if (!by_day.empty()) json["sun_up"] = json_of(between_nodes_error(table, by_day));
  if (!in_twilight.empty()) json["sun_below_horizon"] = json_of(between_nodes_error(table, in_twilight));
  return json;
}

}  // namespace skylut
