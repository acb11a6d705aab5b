#include "skylut/table/table_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr double kCandelaPerKilocandela = 1000.0;

Range range_of(const std::vector<double>& values, const char* unit) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return {*lowest, *highest, unit};
}

void require_node(const char* what, double value, const std::vector<double>& nodes, const char* unit) {
  if (std::find(nodes.begin(), nodes.end(), value) == nodes.end())
    throw InputError("{} {}{}: must be one of the table's {}{}", what, value, unit, fmt::join(nodes, ", "),
                     unit);
}

ModelInfo info_of(const Table& table) {
  std::vector<double> sun_zeniths;
  for (const Direction& sun : table.axes().suns) sun_zeniths.push_back(sun.zenith_deg);
  return {.name = "table",
          .title = "fitted table",
          .source = table.provenance() ? table.provenance()->command : "",
          .quantities = "Y, x, y",
          .altitude_km = range_of(table.axes().altitudes_km, "km"),
          .turbidity_kind = table.turbidity_kind(),
          .turbidity = range_of(table.axes().turbidities, ""),
          .sun_zenith_deg = range_of(sun_zeniths, "deg"),
          .view_zenith_deg = {0.0, 90.0, "deg"}};
}

}  // namespace

PerezSky sky_of(const TableEntry& entry) {
  return {{entry.Y, entry.x, entry.y},
          {entry.zenith.Y * kCandelaPerKilocandela, entry.zenith.x, entry.zenith.y},
          entry.sun,
          entry.horizon_zenith_deg};
}

TableModel::TableModel(Table table) : table_(std::move(table)), info_(info_of(table_)) {}

std::unique_ptr<const Sky> TableModel::at(const SkyConditions& conditions) const {
  const TableAxes& axes = table_.axes();
  if (conditions.turbidity.kind != info_.turbidity_kind)
    throw InputError("turbidity of kind {}: must be the table's, {}",
                     turbidity_kind_name(conditions.turbidity.kind),
                     turbidity_kind_name(info_.turbidity_kind));
  require_node("altitude", conditions.altitude_km, axes.altitudes_km, " km");
  require_node("turbidity", conditions.turbidity.value, axes.turbidities, "");
  const TableEntry* const entry =
      table_.find(conditions.altitude_km, conditions.turbidity.value, conditions.sun);
  if (entry != nullptr) return std::make_unique<const PerezSky>(sky_of(*entry));
  std::vector<std::string> suns;
  for (const Direction& sun : axes.suns)
    suns.push_back(fmt::format("{}:{}", sun.zenith_deg, sun.azimuth_deg));
  throw InputError("sun {}:{} deg at altitude {} km, turbidity {}: must be one of the table's {}",
                   conditions.sun.zenith_deg, conditions.sun.azimuth_deg, conditions.altitude_km,
                   conditions.turbidity.value, fmt::join(suns, ", "));
}

}  // namespace skylut
