#include "skylut/core/json_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

/// A value as it stands in the file, shortened to fit in one line.
std::string shown(const nlohmann::ordered_json& value) {
  constexpr std::size_t kLongest = 60;
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "…";
  return text;
}

}  // namespace

void JsonReader::refuse(const std::string& message) const { throw InputError("{}: {}", name_, message); }

JsonReader JsonReader::at(const std::string& key) const {
  if (!value_->is_object()) refuse(fmt::format("{} must be an object", shown(*value_)));
  const auto found = value_->find(key);
  if (found == value_->end()) refuse(fmt::format("key \"{}\" is missing", key));
  return {*found, fmt::format("{}: {}", name_, key)};
}

std::vector<JsonReader> JsonReader::elements() const {
  if (!value_->is_array() || value_->empty())
    refuse(fmt::format("{} must be an array with at least one element", shown(*value_)));
  std::vector<JsonReader> found;
  for (std::size_t i = 0; i < value_->size(); ++i)
    found.emplace_back((*value_)[i], fmt::format("{}[{}]", name_, i));
  return found;
}

double JsonReader::number(double lower, double upper, const std::string& range) const {
  const double found = value_->is_number() ? value_->get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (!(found >= lower && found <= upper && std::isfinite(found)))
    refuse(fmt::format("{} must be a number {}", shown(*value_), range));
  return found;
}

double JsonReader::number() const {
  return number(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max(), "that is finite");
}

std::string JsonReader::text() const {
  if (!value_->is_string()) refuse(fmt::format("{} must be a text", shown(*value_)));
  return value_->get<std::string>();
}

std::vector<double> JsonReader::numbers(double lower, double upper, const std::string& range) const {
  std::vector<double> found;
  for (const JsonReader& element : elements()) found.push_back(element.number(lower, upper, range));
  return found;
}

void JsonReader::only(const std::vector<std::string>& known) const {
  if (!value_->is_object()) refuse(fmt::format("{} must be an object", shown(*value_)));
  for (const auto& [key, ignored] : value_->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse(fmt::format("unknown key \"{}\": known are {}", key, fmt::join(known, ", ")));
}

nlohmann::ordered_json read_json_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) throw InputError("{}: cannot be read", path);
  std::ostringstream content;
  content << file.rdbuf();
  try {
    return nlohmann::ordered_json::parse(content.str());
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError("{}: not valid JSON near byte {}", path, error.byte);
  } catch (const nlohmann::json::exception&) {
    throw InputError("{}: holds a number out of range: must fit in double precision", path);
  }
}

}  // namespace skylut
