#include "skylut/export/directions_csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    std::string_view field = line.substr(0, comma);
    while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
    while (!field.empty() && (field.back() == ' ' || field.back() == '\r')) field.remove_suffix(1);
    fields.emplace_back(field);
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

// Where a line stands, for messages.
struct LinePlace {
  const std::filesystem::path& file;
  std::size_t line;

  std::string text() const { return fmt::format("{}:{}", file.string(), line); }
};

std::size_t column_of(const std::vector<std::string>& header, const char* name, const LinePlace& place) {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end())
    throw InputError("{}: no column {}; the header must name zenith_deg and azimuth_deg", place.text(), name);
  return static_cast<std::size_t>(found - header.begin());
}

double angle(const std::vector<std::string>& fields, std::size_t column, const char* name, double lowest,
             double highest, const LinePlace& place) {
  if (column >= fields.size()) throw InputError("{}: {} is missing: must be a number", place.text(), name);
  const std::string& text = fields[column];
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !(value >= lowest && value <= highest))
    throw InputError("{}: {} '{}': must be a number within {} to {} deg", place.text(), name, text, lowest, highest);
  return value;
}

}  // namespace

std::vector<Direction> read_directions_csv(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path);
  if (std::filesystem::is_directory(path, ignored) || !file)
    throw InputError("{}: cannot read it: must be a CSV file of directions", path.string());
  std::vector<Direction> directions;
  std::vector<std::string> header;
  std::size_t zenith = 0;
  std::size_t azimuth = 0;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    const LinePlace place{path, ++number};
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    const std::vector<std::string> fields = fields_of(line);
    if (header.empty()) {
      header = fields;
      zenith = column_of(header, "zenith_deg", place);
      azimuth = column_of(header, "azimuth_deg", place);
      continue;
    }
    directions.push_back({angle(fields, zenith, "zenith_deg", 0.0, 180.0, place),
                          angle(fields, azimuth, "azimuth_deg", -360.0, 360.0, place)});
  }
  if (directions.empty())
    throw InputError("{}: no directions: needs a header zenith_deg,azimuth_deg and one row or more", path.string());
  return directions;
}

}  // namespace skylut
