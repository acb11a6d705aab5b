#include "core/toml_reader.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "input_file.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// Tables within tables are destroyed by recursion; the library bounds nested values but not dotted keys.
// Counts the dots of what may be a key: outside quotes and comments, and not between = and the next , or {.
void refuse_long_keys(const std::string& text, const std::string& file) {
  std::size_t line = 1;
  std::size_t dots = 0;
  bool in_key = true;
  bool in_comment = false;
  char quote = 0;
  for (const char character : text) {
    if (character == '\n') {
      ++line;
      dots = 0;
      in_key = true;
      in_comment = false;
      quote = 0;
    } else if (in_comment || quote != 0) {
      if (character == quote) quote = 0;
    } else if (character == '"' || character == '\'') {
      quote = character;
    } else if (character == '#') {
      in_comment = true;
    } else if (character == '=' || character == ',' || character == '{') {
      in_key = character != '=';
      dots = 0;
    } else if (in_key && character == '.' && ++dots >= domain::kDeepestNesting) {
      throw InputError("{}:{}: a dotted key of more than {} parts", file, line, domain::kDeepestNesting);
    }
  }
}

}  // namespace

toml::table TomlReader::parse(const std::string& file) {
  const std::string text = read_input_file(file, "a file in TOML");
  refuse_long_keys(text, file);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError("{}:{}: broken TOML: {}", file, error.source().begin.line, error.description());
  }
}

TomlReader::TomlReader(const toml::table& table, std::string file, std::string prefix)
    : table_(table), file_(std::move(file)), prefix_(std::move(prefix)) {}

void TomlReader::refuse(std::string_view key, const std::string& message) const {
  const toml::node* found = table_.get(key);
  if (found == nullptr) throw InputError("{}: {}{}: {}", file_, prefix_, key, message);
  throw InputError("{}:{}: {}{}: {}", file_, found->source().begin.line, prefix_, key, message);
}

void TomlReader::refuse(std::string_view key, std::size_t index, double value,
                        const std::string& message) const {
  const toml::node* element = &table_.at(key);
  if (const toml::array* list = element->as_array()) element = list->get(index);
  throw InputError("{}:{}: {}{}[{}] = {}: {}", file_, element->source().begin.line, prefix_, key, index,
                   value, message);
}

void TomlReader::allow_only(std::initializer_list<std::string_view> allowed) const {
  allow_only(std::vector<std::string_view>(allowed));
}

void TomlReader::allow_only(const std::vector<std::string_view>& allowed) const {
  for (const std::string& key : keys())
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
      refuse(key, fmt::format("unknown key; expected one of {}", fmt::join(allowed, ", ")));
}

bool TomlReader::is_number(std::string_view key) const {
  const toml::node* found = table_.get(key);
  return found != nullptr && found->is_number();
}

std::vector<std::string> TomlReader::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table_) keys.emplace_back(key.str());
  return keys;
}

const toml::node& TomlReader::node(std::string_view key, const char* expected) const {
  const toml::node* found = table_.get(key);
  if (found == nullptr) refuse(key, fmt::format("is missing; expected {}", expected));
  return *found;
}

std::string TomlReader::text(std::string_view key) const {
  const auto value = node(key, "a text").value_exact<std::string>();
  if (!value || value->empty()) refuse(key, "must be a text in quotes, not empty");
  return *value;
}

double TomlReader::number(std::string_view key) const {
  const auto value = node(key, "a number").value<double>();
  if (!value) refuse(key, "must be a number");
  if (!std::isfinite(*value)) refuse(key, fmt::format("is {}; must be a finite number", *value));
  return *value;
}

std::vector<double> TomlReader::numbers(std::string_view key) const {
  const toml::array* list = node(key, "a list of numbers").as_array();
  if (list == nullptr || list->empty()) refuse(key, "must be a list of numbers, not empty");
  std::vector<double> values;
  values.reserve(list->size());
  for (const toml::node& element : *list) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value) refuse(key, fmt::format("entry {} is no number", values.size()));
    if (!std::isfinite(*value)) refuse(key, values.size(), *value, "must be a finite number");
    values.push_back(*value);
  }
  return values;
}

TomlReader TomlReader::table(std::string_view key) const {
  const toml::table* found = node(key, fmt::format("a table [{}{}]", prefix_, key).c_str()).as_table();
  if (found == nullptr) refuse(key, fmt::format("must be a table [{}{}]", prefix_, key));
  return {*found, file_, fmt::format("{}{}.", prefix_, key)};
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) const {
  const toml::array* list = node(key, fmt::format("a list [[{}{}]]", prefix_, key).c_str()).as_array();
  if (list == nullptr || list->empty()) refuse(key, fmt::format("must be a list [[{}{}]]", prefix_, key));
  std::vector<TomlReader> readers;
  for (const toml::node& element : *list) {
    if (!element.is_table()) refuse(key, fmt::format("must be a list [[{}{}]]", prefix_, key));
    readers.push_back({*element.as_table(), file_, fmt::format("{}{}[{}].", prefix_, key, readers.size())});
  }
  return readers;
}

}  // namespace skylut
