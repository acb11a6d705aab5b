#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kind.hpp"
#include "skylut/core/domain.hpp"

/// Numbers on the command line: decimal, with a point in every locale; "+5" and "1e3" are numbers, blanks
/// around one do not matter. NaN and infinity are refused.
namespace skylut::cli {

/// @throws InputError  "must be a number within 0 to 30 km"
double read_number(const std::string& text, const Range& range);

Kind<double> number(const Range& range);

/// A whole number; both limits included, at most 2^53.
Kind<std::int64_t> whole_number(const Range& range);

/// Numbers separated by commas, at least one.
Kind<std::vector<double>> numbers(const Range& range);

/// Numbers separated by commas, or LO:HI:STEP: upwards in a whole number of steps.
Kind<std::vector<double>> numbers_or_steps(const Range& range, int most_steps);

/// NAME=VALUE pairs separated by commas.
using NamedNumbers = std::vector<std::pair<std::string, double>>;
Kind<NamedNumbers> named_numbers();

/// The parts of a text between separators, without the blanks around them.
std::vector<std::string> parts_of(const std::string& text, char separator);

/// A number that reads back as the same number, in the fewest digits.
std::string written(double value);

/// Texts with a separator between them.
template <class List, class Write>
std::string joined(const List& list, Write write) {
  std::string text;
  for (const auto& element : list) text += (text.empty() ? "" : ",") + write(element);
  return text;
}

}  // namespace skylut::cli
