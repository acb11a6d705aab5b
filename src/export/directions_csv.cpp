#include "skylut/export/directions_csv.hpp"

#include "skylut/core/csv.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

double angle_deg(const CsvTable& table, std::size_t row, const char* name, const Range& range) {
  const double value = table.number(row, table.column(name));
  if (!range.holds(value))
    throw InputError("{}: {} {}: must lie within {} to {}", table.place(row), name, value, range.lowest,
                     range.highest);
  return value;
}

}  // namespace

std::vector<Direction> read_directions_csv(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  std::vector<Direction> directions;
  for (std::size_t row = 0; row < table.rows(); ++row)
    directions.push_back({angle_deg(table, row, "zenith_deg", domain::kAnyZenith_deg),
                          wrapped_azimuth_deg(angle_deg(table, row, "azimuth_deg", domain::kAzimuth_deg))});
  if (directions.empty()) throw InputError("{}: no rows: must hold one direction or more", path.string());
  return directions;
}

}  // namespace skylut
