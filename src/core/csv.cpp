#include "skylut/core/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "input_file.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.emplace_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// What cannot be printed on one line is shown as '?', and a long field shortened.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string result(text.substr(0, kLongest));
  for (char& character : result)
    if (static_cast<unsigned char>(character) < 0x20 || character == 0x7f) character = '?';
  return text.size() > kLongest ? result + "…" : result;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += ',';
    text += name;
  }
  return shown(text);
}

}  // namespace

CsvTable CsvTable::read(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path))
    throw InputError("{}: is a directory, must be a comma-separated file", path.string());
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("{}: cannot read: must be a comma-separated file that exists", path.string());
  CsvTable table;
  table.path_ = path;
  std::string text;
  for (std::size_t number = 1; read_input_line(file, text, path, number); ++number) {
    std::string_view line = text;
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    line = trimmed(line);
    if (line.empty()) continue;
    if (line.front() == '#') {
      const std::size_t equals = line.find('=');
      if (equals != std::string_view::npos)
        table.comments_.push_back({number, std::string(trimmed(line.substr(1, equals - 1))),
                                   std::string(trimmed(line.substr(equals + 1)))});
      continue;
    }
    std::vector<std::string> fields = split(line);
    if (table.columns_.empty()) {
      for (std::size_t i = 0; i < fields.size(); ++i)
        if (std::find(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(i), fields[i]) !=
            fields.begin() + static_cast<std::ptrdiff_t>(i))
          throw InputError("{}:{}: column '{}' is named twice: every column must have its own name",
                           path.string(), number, shown(fields[i]));
      table.columns_ = std::move(fields);
      continue;
    }
    if (fields.size() != table.columns_.size())
      throw InputError("{}:{}: {} fields: must be {}, as the header names", path.string(), number,
                       fields.size(), table.columns_.size());
    table.rows_.push_back({number, std::move(fields)});
  }
  if (table.columns_.empty())
    throw InputError("{}: is empty: the first line must name the columns", path.string());
  return table;
}

std::optional<std::size_t> CsvTable::find_column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvTable::column(std::string_view name) const {
  if (const auto found = find_column(name)) return *found;
  throw InputError("{}: no column '{}' among '{}': the header must name it", path_.string(), name,
                   joined(columns_));
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& field = rows_[row].fields[column];
  if (const auto value = parse_number(field)) return *value;
  throw InputError("{}: column '{}': '{}': must be a finite number", place(row), columns_[column],
                   shown(field));
}

std::optional<std::string> CsvTable::comment(std::string_view name) const {
  for (const Comment& comment : comments_)
    if (comment.name == name) return comment.value;
  return std::nullopt;
}

std::optional<double> CsvTable::comment_number(std::string_view name) const {
  for (const Comment& comment : comments_) {
    if (comment.name != name) continue;
    if (const auto value = parse_number(comment.value)) return value;
    throw InputError("{}:{}: {}={}: must be a finite number", path_.string(), comment.line, name,
                     shown(comment.value));
  }
  return std::nullopt;
}

std::string CsvTable::place(std::size_t row) const {
  return fmt::format("{}:{}", path_.string(), rows_[row].line);
}

}  // namespace skylut
