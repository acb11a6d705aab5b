#include "spectral_table.hpp"

#include "skylut/core/context.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

std::vector<std::vector<double>> read_rows(const std::string& path, std::size_t columns) {
  const CsvTable table = CsvTable::read(path);
  if (table.columns().size() != columns)
    throw InputError("{}: {} columns: must be {}", path, table.columns().size(), columns);
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::vector<double> row;
    for (std::size_t column = 0; column < columns; ++column) row.push_back(table.number(i, column));
    if (i > 0 && !(row[0] > rows.back()[0])) throw InputError("{}: wavelengths must ascend", table.place(i));
    rows.push_back(std::move(row));
  }
  if (rows.size() < 2) throw InputError("{}: {} rows: must have two or more", path, rows.size());
  return rows;
}

}  // namespace

std::vector<std::vector<double>> read_spectral_table(const Context& context, const std::string& relative_path,
                                                     std::size_t columns) {
  const std::string path = context.data_file(relative_path).string();
  try {
    return read_rows(path, columns);
  } catch (const InputError& error) {
    // Ours, not the user's: the data that came with skylut were changed.
    throw WorkError("{}: data file is damaged", error.what());
  }
}

}  // namespace skylut
