#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skylut {

/// Reads a table of a TOML file; every complaint is one line "file:line: key = value: what would be right".
class TomlReader {
 public:
  /// Parses a file. The result must outlive its readers.
  /// @throws InputError  if it cannot be read or its syntax is broken (file, line, reason)
  static toml::table parse(const std::string& file);

  /// @param prefix  dotted path of the table in the file, with its final dot; "" for the whole file
  TomlReader(const toml::table& table, std::string file, std::string prefix);

  /// @throws InputError  for the first key that is not one of these
  void allow_only(std::initializer_list<std::string_view> keys) const;
  void allow_only(const std::vector<std::string_view>& keys) const;

  bool has(std::string_view key) const { return table_.contains(key); }
  bool is_number(std::string_view key) const;
  std::string text(std::string_view key) const;
  double number(std::string_view key) const;
  /// A list of finite numbers, not empty.
  std::vector<double> numbers(std::string_view key) const;
  /// A table below this one. @throws InputError if it is missing or is no table
  TomlReader table(std::string_view key) const;
  /// Tables of a list [[key]] below this one, at least one. @throws InputError if it is missing or holds
  /// something else
  std::vector<TomlReader> tables(std::string_view key) const;
  std::vector<std::string> keys() const;

  /// Complains about a key (with its line if it is there): "file:line: prefix.key: message".
  [[noreturn]] void refuse(std::string_view key, const std::string& message) const;
  /// Complains about one value of a list: "file:line: prefix.key[index] = value: message".
  [[noreturn]] void refuse(std::string_view key, std::size_t index, double value,
                           const std::string& message) const;

 private:
  const toml::node& node(std::string_view key, const char* expected) const;

  const toml::table& table_;
  std::string file_;
  std::string prefix_;
};

}  // namespace skylut
