#include "skylut/table/held_out_skies.hpp"

#include <algorithm>

#include "skylut/core/low_discrepancy.hpp"

namespace skylut {

namespace {

constexpr double kHorizon_deg = 90.0;
constexpr std::size_t kLoads = 8;
constexpr std::size_t kAltitudes = 5;
constexpr std::size_t kSunsUp = 5;
constexpr std::size_t kSunsDown = 2;

// Members `first` to first + count of that sequence in a range.
std::vector<double> spread(const Range& range, std::size_t first, std::size_t count, std::size_t base) {
  if (range.lowest >= range.highest) return {range.highest};
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(range.lowest + low_discrepancy(first + i, base) * (range.highest - range.lowest));
  return values;
}

HeldOutSky held_out(const TableSky& sky, const TableEntry& alone) {
  HeldOutSky held{alone, {}, sky.check.solid_angles_sr, sky.check.colour};
  held.alone.sun.azimuth_deg = 0.0;  // from which the views' azimuths count
  for (const RelativeView& view : sky.check.views)
    held.directions.push_back({view.zenith_deg, view.relative_azimuth_deg});
  return held;
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
                                       const TransferOptions& transfer, const TableSampling& sampling,
                                       const TableFitOptions& fit, const ModelInfo& domain) {
  TableFitOptions alone = fit;
  alone.branch_tolerance = 0.0;
  TableSampling without_maps = sampling;
  without_maps.map_directions.clear();
  std::vector<HeldOutSky> all;
  for (const HeldOutConditions& conditions : held_out_conditions(domain)) {
    SkyScene held = scene;
    held.turbidities = {{domain.turbidity_kind, conditions.turbidity}};
    held.altitudes_km = conditions.altitudes_km;
    held.suns.clear();
    for (const double sun_deg : conditions.sun_zeniths_deg) held.suns.push_back({sun_deg, 0.0});
    const TableSkies skies = simulate_table_skies(context, held, transfer, without_maps);
    const SkyTable rows = fit_table(context, skies.skies, alone);
    for (std::size_t i = 0; i < skies.skies.size(); ++i)
      all.push_back(held_out(skies.skies[i], rows.entries[i]));
  }
  return all;
}

}  // namespace skylut
