#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace skylut::cli {

/// What a number on the command line may be, both ends included; `unit` is for messages and may be empty.
struct NumberRange {
  double lowest = 0.0;
  double highest = 0.0;
  std::string unit;
};

/// Reads one number. Plain decimal, independent of the locale; NaN and infinity are refused.
/// @param what  the option's name, for the message
/// @throws InputError  if the text is not a number within the range
double parse_number(const std::string& what, const std::string& text, const NumberRange& range);

/// Reads numbers separated by commas, at least one. @throws InputError as parse_number
std::vector<double> parse_numbers(const std::string& what, const std::string& text, const NumberRange& range);

/// Adds an option that holds one number; the value given becomes its default in --help.
CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, const NumberRange& range,
                        const std::string& description);

/// Adds an option that holds a whole number.
CLI::Option* add_count(CLI::App& command, const std::string& name, int& value, int lowest, int highest,
                       const std::string& description);

/// Adds an option that holds numbers separated by commas.
CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<double>& values,
                         const NumberRange& range, const std::string& description);

}  // namespace skylut::cli
