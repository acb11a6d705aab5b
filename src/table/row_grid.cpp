#include "row_grid.hpp"

#include <algorithm>

namespace skylut {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::vector<double> ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::size_t index_of(const std::vector<double>& nodes, double value) {
  return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), value) - nodes.begin());
}

}  // namespace

std::optional<RowGrid> RowGrid::of(const Table& table) {
  RowGrid grid;
  grid.altitudes_km_ = ascending(table.axes().altitudes_km);
  grid.turbidities_ = ascending(table.axes().turbidities);
  std::vector<double> zeniths;
  for (const Direction& sun : table.axes().suns) zeniths.push_back(sun.zenith_deg);
  grid.sun_zeniths_deg_ = ascending(std::move(zeniths));
  grid.rows_.assign(grid.altitudes_km_.size() * grid.turbidities_.size() * grid.sun_zeniths_deg_.size(),
                    kNone);
  for (std::size_t i = 0; i < table.entries().size(); ++i) {
    const TableEntry& entry = table.entries()[i];
    const std::size_t place = (index_of(grid.altitudes_km_, entry.altitude_km) * grid.turbidities_.size() +
                               index_of(grid.turbidities_, entry.turbidity)) *
                                  grid.sun_zeniths_deg_.size() +
                              index_of(grid.sun_zeniths_deg_, entry.sun.zenith_deg);
    if (grid.rows_[place] == kNone) grid.rows_[place] = i;  // of mirrored suns the first
  }
  if (std::find(grid.rows_.begin(), grid.rows_.end(), kNone) != grid.rows_.end()) return std::nullopt;
  return grid;
}

}  // namespace skylut
