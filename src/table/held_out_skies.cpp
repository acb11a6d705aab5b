#include "skylut/table/held_out_skies.hpp"

#include <algorithm>

#include "skylut/core/constants.hpp"
#include "skylut/table/fit_table.hpp"

namespace skylut {

namespace {

constexpr double kHorizon_deg = 90.0;
constexpr std::size_t kLoads = 8;
constexpr std::size_t kAltitudes = 5;
constexpr std::size_t kSunsUp = 5;
constexpr std::size_t kSunsDown = 2;

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

// Members `first` to first + count of that sequence in a range.
std::vector<double> spread(const Range& range, std::size_t first, std::size_t count, std::size_t base) {
  if (range.lowest >= range.highest) return {range.highest};
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(range.lowest + halton(first + i, base) * (range.highest - range.lowest));
  return values;
}

// Rings that the fits do not see, on the sun's one side: the other is its mirror image.
std::vector<Direction> check_directions() {
  std::vector<Direction> directions{{0.0, 0.0}};
  for (double zenith_deg = 3.0; zenith_deg < 90.0; zenith_deg += zenith_deg < 86.0 ? 3.0 : 1.0)
    for (double azimuth_deg = 5.0; azimuth_deg < 180.0; azimuth_deg += 10.0)
      directions.push_back({zenith_deg, azimuth_deg});
  return directions;
}

HeldOutSky held_out(const SkyMap& map, std::size_t fitted, const TableEntry& alone) {
  const auto first = static_cast<std::ptrdiff_t>(fitted);
  HeldOutSky held{alone,
                  {map.directions.begin() + first, map.directions.end()},
                  {},
                  {map.colour.begin() + first, map.colour.end()}};
  std::vector<double> zenith_rad;
  for (const Direction& direction : held.directions)
    zenith_rad.push_back(direction.zenith_deg * kRadiansPerDegree);
  held.solid_angles_sr = solid_angle_weights(zenith_rad);
  return held;
}

SkyMap first_of(const SkyMap& map, std::size_t directions) {
  SkyMap part = map;
  part.directions.resize(directions);
  part.colour.resize(directions);
  part.radiance.resize(directions * map.wavelengths.size());
  return part;
}

}  // namespace

std::vector<HeldOutConditions> held_out_conditions(const ModelInfo& domain) {
  const Range& suns = domain.sun_zenith_deg;
  const Range up{suns.lowest, std::min(suns.highest, kHorizon_deg)};
  const Range down{std::max(suns.lowest, kHorizon_deg), suns.highest};
  const std::vector<double> loads = spread(domain.turbidity, 1, kLoads, 2);
  std::vector<HeldOutConditions> all;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    HeldOutConditions conditions;
    conditions.turbidity = loads[i];
    conditions.altitudes_km = spread(domain.altitude_km, 1 + i * kAltitudes, kAltitudes, 3);
    if (up.lowest <= up.highest) conditions.sun_zeniths_deg = spread(up, 1 + i * kSunsUp, kSunsUp, 5);
    if (down.lowest < down.highest)
      for (const double sun_deg : spread(down, 1 + i * kSunsDown, kSunsDown, 5))
        conditions.sun_zeniths_deg.push_back(sun_deg);
    all.push_back(conditions);
  }
  return all;
}

std::vector<HeldOutSky> held_out_skies(const Context& context, const SkyScene& scene,
                                       const TransferOptions& transfer, const SkyFitOptions& fit,
                                       const ModelInfo& domain) {
  const std::size_t fitted = scene.directions.size();
  SkyScene held = scene;
  for (const Direction& direction : check_directions()) held.directions.push_back(direction);
  std::vector<HeldOutSky> all;
  for (const HeldOutConditions& conditions : held_out_conditions(domain)) {
    held.turbidities = {{domain.turbidity_kind, conditions.turbidity}};
    held.altitudes_km = conditions.altitudes_km;
    held.suns.clear();
    for (const double sun_deg : conditions.sun_zeniths_deg) held.suns.push_back({sun_deg, 0.0});
    const std::vector<SkyMap> maps = simulate_sky(context, held, transfer);
    std::vector<SkyMap> to_fit;
    for (const SkyMap& map : maps) to_fit.push_back(first_of(map, fitted));
    const SkyTable rows = fit_table(context, to_fit, fit);
    for (std::size_t i = 0; i < maps.size(); ++i) all.push_back(held_out(maps[i], fitted, rows.entries[i]));
  }
  return all;
}

}  // namespace skylut
