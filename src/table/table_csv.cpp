#include "skylut/table/table_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "skylut/core/atomic_file.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// Every column with the field it holds, in the order of the file.
struct Column {
  std::string name;
  double& (*field)(TableEntry&);
};

template <PerezCoefficients TableEntry::*channel>
void append_channel(std::vector<Column>& columns, const std::string& name) {
  columns.push_back({"A_" + name, [](TableEntry& e) -> double& { return (e.*channel).A; }});
  columns.push_back({"B_" + name, [](TableEntry& e) -> double& { return (e.*channel).B; }});
  columns.push_back({"C_" + name, [](TableEntry& e) -> double& { return (e.*channel).C; }});
  columns.push_back({"D_" + name, [](TableEntry& e) -> double& { return (e.*channel).D; }});
  columns.push_back({"E_" + name, [](TableEntry& e) -> double& { return (e.*channel).E; }});
}

std::vector<Column> table_columns() {
  std::vector<Column> columns{
      {"altitude_km", [](TableEntry& e) -> double& { return e.altitude_km; }},
      {"turbidity", [](TableEntry& e) -> double& { return e.turbidity; }},
      {"sun_zenith_deg", [](TableEntry& e) -> double& { return e.sun.zenith_deg; }},
      {"sun_azimuth_deg", [](TableEntry& e) -> double& { return e.sun.azimuth_deg; }},
  };
  append_channel<&TableEntry::Y>(columns, "Y");
  append_channel<&TableEntry::x>(columns, "x");
  append_channel<&TableEntry::y>(columns, "y");
  columns.push_back({"Y_zenith_kcd_m2", [](TableEntry& e) -> double& { return e.zenith.Y; }});
  columns.push_back({"x_zenith", [](TableEntry& e) -> double& { return e.zenith.x; }});
  columns.push_back({"y_zenith", [](TableEntry& e) -> double& { return e.zenith.y; }});
  columns.push_back({"rmse_Y_rel", [](TableEntry& e) -> double& { return e.rmse_Y_rel; }});
  columns.push_back({"rmse_x", [](TableEntry& e) -> double& { return e.rmse_x; }});
  columns.push_back({"rmse_y", [](TableEntry& e) -> double& { return e.rmse_y; }});
  return columns;
}

}  // namespace

std::string table_csv_header() {
  std::string header;
  for (const Column& column : table_columns()) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  return header;
}

std::string format_table_csv(std::span<const TableEntry> entries) {
  const std::vector<Column> columns = table_columns();
  std::string text = table_csv_header() + "\n";
  for (TableEntry entry : entries)
    for (std::size_t i = 0; i < columns.size(); ++i)
      text += fmt::format("{}{}", columns[i].field(entry), i + 1 == columns.size() ? "\n" : ",");
  return text;
}

void write_table_csv(const std::filesystem::path& path, std::span<const TableEntry> entries) {
  write_text_atomically(path, format_table_csv(entries));
}

std::vector<TableEntry> read_table_csv(const std::filesystem::path& path) {
  const CsvTable csv = CsvTable::read(path);
  const std::vector<Column> columns = table_columns();
  std::vector<std::size_t> at;
  for (const Column& column : columns) at.push_back(csv.column(column.name));
  if (csv.rows() == 0) throw InputError("{}: holds no rows: must have at least one", path.string());
  std::vector<TableEntry> entries(csv.rows());
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].field(entries[row]) = csv.number(row, at[i]);
    const TableEntry& entry = entries[row];
    if (!(entry.sun.zenith_deg >= 0.0 && entry.sun.zenith_deg <= 180.0))
      throw InputError("{}: sun_zenith_deg {}: must lie within 0-180", csv.place(row), entry.sun.zenith_deg);
    if (!(entry.zenith.Y > 0.0))
      throw InputError("{}: Y_zenith_kcd_m2 {}: must be greater than 0", csv.place(row), entry.zenith.Y);
  }
  return entries;
}

}  // namespace skylut
