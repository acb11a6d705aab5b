#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "skylut/site/sun.hpp"

namespace skylut {

/// Moments at equal distances: start, start + step, … up to and, where a step falls on it, with the end.
struct TimeSteps {
  UtcTime start;  ///< whole seconds, as end; no leap second
  UtcTime end;
  std::int64_t step_s = 3600;  ///< [1, 366 days]

  bool operator==(const TimeSteps&) const = default;
};

/// Reads a length of time: "10min", "1h", "30s", "1d", "1h30min", or as ISO 8601 has it, "PT15M", "P1DT12H".
/// Whole numbers; a minute is min, in ISO 8601 M.
/// @return seconds, [1, 366 days]
/// @throws InputError  naming the text and what would be right
std::int64_t parse_duration_s(const std::string& text);

/// Writes a length of time as parse_duration_s reads it, in the largest unit that divides it: "90min".
std::string format_duration(std::int64_t seconds);

/// Reads START/END/STEP: two times as parse_time reads them, of whole seconds, and a length of time.
/// @throws InputError  naming the text and what is wrong: no three parts, an end before its start, more than
///                     100 000 times, or what the parts' readers refuse
TimeSteps parse_time_steps(const std::string& text);

/// Writes them so that parse_time_steps reads the same.
std::string format_time_steps(const TimeSteps& steps);

/// The moments themselves, ascending. Days have 86 400 s: a leap second among them is not counted.
/// @throws InputError  as parse_time_steps
std::vector<UtcTime> times_of(const TimeSteps& steps);

/// Reads moments from a comma-separated file whose header names a column time, in any order, other columns
/// ignored; lines that begin with # are comments.
/// @throws InputError  "file:line: what is wrong, what would be right"; no rows, more than 100 000
std::vector<UtcTime> read_times_csv(const std::filesystem::path& path);

}  // namespace skylut
