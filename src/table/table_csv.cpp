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

template <FormulaNotes TableEntry::*notes>
void append_worst(std::vector<Column>& columns, const std::string& name, const std::string& unit) {
  columns.push_back({"worst_" + name + unit, [](TableEntry& e) -> double& { return (e.*notes).worst; }});
  columns.push_back({"worst_" + name + "_zenith_deg",
                     [](TableEntry& e) -> double& { return (e.*notes).worst_direction.zenith_deg; }});
  columns.push_back({"worst_" + name + "_azimuth_deg",
                     [](TableEntry& e) -> double& { return (e.*notes).worst_direction.azimuth_deg; }});
}

// Those that tables of skylut 0.1 lack; a file that has none of them is read too.
std::vector<Column> later_columns() {
  std::vector<Column> columns{
      {"rmse_horizon_Y_rel", [](TableEntry& e) -> double& { return e.notes_Y.rmse_horizon; }},
      {"rmse_horizon_x", [](TableEntry& e) -> double& { return e.notes_x.rmse_horizon; }},
      {"rmse_horizon_y", [](TableEntry& e) -> double& { return e.notes_y.rmse_horizon; }},
  };
  append_worst<&TableEntry::notes_Y>(columns, "Y", "_rel");
  append_worst<&TableEntry::notes_x>(columns, "x", "");
  append_worst<&TableEntry::notes_y>(columns, "y", "");
  columns.push_back({"horizon_zenith_deg", [](TableEntry& e) -> double& { return e.horizon_zenith_deg; }});
  columns.push_back({"Y_below_90_kcd_m2", [](TableEntry& e) -> double& { return e.Y_below_90_kcd_m2; }});
  columns.push_back({"light_below_90", [](TableEntry& e) -> double& { return e.light_below_90; }});
  return columns;
}

struct TextColumn {
  std::string name;
  std::string& (*field)(TableEntry&);
};

std::vector<TextColumn> flag_columns() {
  return {{"undetermined_Y", [](TableEntry& e) -> std::string& { return e.notes_Y.undetermined; }},
          {"undetermined_x", [](TableEntry& e) -> std::string& { return e.notes_x.undetermined; }},
          {"undetermined_y", [](TableEntry& e) -> std::string& { return e.notes_y.undetermined; }},
          {"at_bound_Y", [](TableEntry& e) -> std::string& { return e.notes_Y.at_bound; }},
          {"at_bound_x", [](TableEntry& e) -> std::string& { return e.notes_x.at_bound; }},
          {"at_bound_y", [](TableEntry& e) -> std::string& { return e.notes_y.at_bound; }}};
}

}  // namespace

std::string table_csv_header() {
  std::string header;
  const auto append = [&header](const auto& columns) {
    for (const auto& column : columns) header += (header.empty() ? "" : ",") + column.name;
  };
  append(table_columns());
  append(later_columns());
  append(flag_columns());
  return header;
}

std::string format_table_csv(std::span<const TableEntry> entries) {
  std::vector<Column> numbers = table_columns();
  for (Column& column : later_columns()) numbers.push_back(std::move(column));
  const std::vector<TextColumn> flags = flag_columns();
  std::string text = table_csv_header() + "\n";
  for (TableEntry entry : entries) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      text += fmt::format("{}{}", i == 0 ? "" : ",", numbers[i].field(entry));
    for (const TextColumn& column : flags) text += "," + column.field(entry);
    text += "\n";
  }
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
    for (const Column& column : later_columns())
      if (const auto there = csv.find_column(column.name))
        column.field(entries[row]) = csv.number(row, *there);
    for (const TextColumn& column : flag_columns())
      if (const auto there = csv.find_column(column.name)) column.field(entries[row]) = csv.text(row, *there);
    const TableEntry& entry = entries[row];
    if (!(entry.horizon_zenith_deg >= 90.0 && entry.horizon_zenith_deg < 180.0))
      throw InputError("{}: horizon_zenith_deg {}: must lie within 90 to below 180", csv.place(row),
                       entry.horizon_zenith_deg);
    if (!(entry.sun.zenith_deg >= 0.0 && entry.sun.zenith_deg <= 180.0))
      throw InputError("{}: sun_zenith_deg {}: must lie within 0-180", csv.place(row), entry.sun.zenith_deg);
    if (!(entry.zenith.Y > 0.0))
      throw InputError("{}: Y_zenith_kcd_m2 {}: must be greater than 0", csv.place(row), entry.zenith.Y);
  }
  return entries;
}

}  // namespace skylut
