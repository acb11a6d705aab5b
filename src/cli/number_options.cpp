#include "number_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "skylut/core/errors.hpp"
#include "skylut/core/text.hpp"

namespace skylut::cli {

namespace {

std::string allowed(const NumberRange& range) {
  const std::string unit = range.unit.empty() ? "" : " " + range.unit;
  if (std::isinf(range.highest)) return fmt::format("a number of at least {}{}", range.lowest, unit);
  return fmt::format("a number within {} to {}{}", range.lowest, range.highest, unit);
}

}  // namespace

double parse_number(const std::string& what, const std::string& text, const NumberRange& range) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool is_number = error == std::errc{} && stop == end && std::isfinite(value);
  if (!is_number || value < range.lowest || value > range.highest)
    throw InputError("{} '{}': must be {}", what, text, allowed(range));
  return value;
}

std::vector<double> parse_numbers(const std::string& what, const std::string& text,
                                  const NumberRange& range) {
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) values.push_back(parse_number(what, part, range));
  return values;
}

CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, const NumberRange& range,
                        const std::string& description) {
  return command
      .add_option_function<std::string>(
          name, [&value, name, range](const std::string& text) { value = parse_number(name, text, range); },
          description)
      ->type_name("NUMBER")
      ->default_str(fmt::format("{}", value));
}

CLI::Option* add_count(CLI::App& command, const std::string& name, int& value, int lowest, int highest,
                       const std::string& description) {
  const auto read = [&value, name, lowest, highest](const std::string& text) {
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end || number < lowest || number > highest)
      throw InputError("{} '{}': must be a whole number within {} to {}", name, text, lowest, highest);
    value = number;
  };
  return command.add_option_function<std::string>(name, read, description)
      ->type_name("COUNT")
      ->default_str(fmt::format("{}", value));
}

CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<double>& values,
                         const NumberRange& range, const std::string& description) {
  return command
      .add_option_function<std::string>(
          name,
          [&values, name, range](const std::string& text) { values = parse_numbers(name, text, range); },
          description)
      ->type_name("LIST")
      ->default_str(fmt::format("{}", fmt::join(values, ",")));
}

}  // namespace skylut::cli
