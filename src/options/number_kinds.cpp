#include "number_kinds.hpp"

#include <charconv>
#include <cmath>

#include "skylut/core/check.hpp"
#include "skylut/core/text.hpp"

namespace skylut::cli {

namespace {

[[maybe_unused]] constexpr double kLargestWhole =
    9007199254740992.0;  // 2^53: every whole number up to it is a double

std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Whether the whole text is one finite number.
bool is_number(const std::string& text, double& value) {
  const std::string digits = trimmed(text);
  const char* begin = digits.data();
  const char* const end = begin + digits.size();
  if (digits.size() > 1 && *begin == '+' && begin[1] != '-') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc{} && stop == end && std::isfinite(value);
}

std::string limits(const Range& range) {
  return fmt::format("within {} to {}{}{}", range.lowest, range.highest, *range.unit == '\0' ? "" : " ",
                     range.unit);
}

// One of several numbers: says which.
double read_part(const std::string& part, const Range& range) {
  double value = 0.0;
  if (!is_number(part, value)) throw InputError("'{}' must be a number {}", part, limits(range));
  if (!range.holds(value)) throw InputError("{} must lie {}", written(value), limits(range));
  return value;
}

std::vector<double> read_list(const std::string& text, const Range& range) {
  const std::vector<std::string> parts = parts_of(text, ',');
  if (parts.size() == 1) return {read_number(text, range)};
  std::vector<double> values;
  for (const std::string& part : parts) values.push_back(read_part(part, range));
  return values;
}

std::vector<double> read_steps(const std::vector<std::string>& parts, const Range& range, int most_steps) {
  const double lowest = read_part(parts[0], range);
  const double highest = read_part(parts[1], range);
  const double step = read_part(parts[2], {0.0, range.highest - range.lowest, range.unit});
  const double steps = step > 0.0 ? std::round((highest - lowest) / step) : -1.0;
  const double rounding = 1e-9 * (range.highest - range.lowest);
  if (!(steps >= 0.0 && steps <= most_steps && std::abs(lowest + steps * step - highest) < rounding))
    throw InputError("must be a whole number of steps upwards, at most {}", most_steps);
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(steps); ++i) values.push_back(lowest + i * step);
  return values;
}

NamedNumbers read_named(const std::string& text) {
  NamedNumbers read;
  for (const std::string& part : parts_of(text, ',')) {
    const std::vector<std::string> sides = parts_of(part, '=');
    double value = 0.0;
    if (sides.size() != 2 || sides[0].empty() || !is_number(sides[1], value))
      throw InputError("must be NAME=VALUE, for example optical-step=0.01");
    read.emplace_back(sides[0], value);
  }
  return read;
}

}  // namespace

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (const std::string& part : split(text, separator)) parts.push_back(trimmed(part));
  return parts;
}

std::string written(double value) { return fmt::format("{}", value); }

double read_number(const std::string& text, const Range& range) {
  double value = 0.0;
  if (!is_number(text, value) || !range.holds(value)) throw InputError("must be a number {}", limits(range));
  return value;
}

Kind<double> number(const Range& range) {
  return {"NUMBER", [range](const std::string& text) { return read_number(text, range); }, written};
}

Kind<std::int64_t> whole_number(const Range& range) {
  SKYLUT_CHECK(std::abs(range.lowest) <= kLargestWhole && std::abs(range.highest) <= kLargestWhole);
  const auto read = [range](const std::string& text) {
    double value = 0.0;
    if (!is_number(text, value) || value != std::floor(value) || !range.holds(value))
      throw InputError("must be a whole number within {} to {}", static_cast<std::int64_t>(range.lowest),
                       static_cast<std::int64_t>(range.highest));
    return static_cast<std::int64_t>(value);
  };
  return {"COUNT", read, [](const std::int64_t& value) { return fmt::format("{}", value); }};
}

Kind<std::vector<double>> numbers(const Range& range) {
  return {"LIST", [range](const std::string& text) { return read_list(text, range); },
          [](const std::vector<double>& values) { return joined(values, written); }};
}

Kind<std::vector<double>> numbers_or_steps(const Range& range, int most_steps) {
  const auto read = [range, most_steps](const std::string& text) {
    const std::vector<std::string> parts = parts_of(text, ':');
    if (parts.size() == 1) return read_list(text, range);
    if (parts.size() != 3)
      throw InputError("must be a list 0,10,90 or LO:HI:STEP{}{}", *range.unit == '\0' ? "" : " in ",
                       range.unit);
    return read_steps(parts, range, most_steps);
  };
  return {"LIST|LO:HI:STEP", read, [](const std::vector<double>& values) { return joined(values, written); }};
}

Kind<NamedNumbers> named_numbers() {
  const auto write = [](const NamedNumbers& values) {
    return joined(values, [](const auto& value) { return value.first + "=" + written(value.second); });
  };
  return {"NAME=VALUE,...", read_named, write};
}

}  // namespace skylut::cli
