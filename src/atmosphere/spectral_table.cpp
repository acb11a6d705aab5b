#include "spectral_table.hpp"

#include <charconv>
#include <fstream>
#include <string_view>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

std::vector<std::vector<double>> read_spectral_table(const Context& context, const std::string& relative_path,
                                                     std::size_t columns) {
  const std::string path = context.data_file(relative_path).string();
  std::ifstream file(path);
  std::vector<std::vector<double>> rows;
  bool named = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (!named) {
      named = true;
      continue;
    }
    std::vector<double> row(columns);
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t i = 0; i < columns; ++i) {
      const auto [stop, error] = std::from_chars(at, end, row[i]);
      const bool separated = i + 1 < columns ? (stop != end && *stop == ',') : stop == end;
      if (error != std::errc{} || !separated)
        throw WorkError("{}:{}: data file is damaged: expected {} numbers", path, number, columns);
      at = stop + 1;
    }
    if (!rows.empty() && !(row[0] > rows.back()[0]))
      throw WorkError("{}:{}: data file is damaged: wavelengths must ascend", path, number);
    rows.push_back(std::move(row));
  }
  if (rows.size() < 2) throw WorkError("{}: data file is damaged: holds no table", path);
  return rows;
}

}  // namespace skylut
