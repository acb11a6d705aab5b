#include "skylut/site/time_steps.hpp"

#include <erfa.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "skylut/core/csv.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/text.hpp"

namespace skylut {

namespace {

constexpr std::int64_t kMinute_s = 60;
constexpr std::int64_t kHour_s = 3600;
constexpr std::int64_t kDay_s = 86400;
constexpr std::int64_t kLongest_s = 366 * kDay_s;
constexpr std::size_t kMostDigits = 9;  // more overflow, and no length in range has them

struct Unit {
  std::string_view name;
  std::int64_t seconds;
};
// Descending: each at most once, and the first that divides a length writes it.
constexpr std::array<Unit, 4> kUnits{{{"d", kDay_s}, {"h", kHour_s}, {"min", kMinute_s}, {"s", 1}}};
constexpr std::array<Unit, 1> kIsoDays{{{"D", kDay_s}}};
constexpr std::array<Unit, 3> kIsoTimes{{{"H", kHour_s}, {"M", kMinute_s}, {"S", 1}}};

[[noreturn]] void refuse_duration(const std::string& text) {
  throw InputError("step '{}': must be a length of time from 1 s to 366 days, for example 10min, 1h or PT15M",
                   text);
}

// Takes numbers with their units off the front of a text for as long as there are any.
template <std::size_t N>
std::int64_t take_amounts(std::string_view& rest, const std::array<Unit, N>& units, const std::string& text) {
  std::int64_t sum = 0;
  std::size_t next = 0;
  while (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits > kMostDigits) refuse_duration(text);
    std::int64_t amount = 0;
    std::from_chars(rest.data(), rest.data() + digits, amount);
    rest.remove_prefix(digits);
    while (next < N && !rest.starts_with(units[next].name)) ++next;
    if (next == N) refuse_duration(text);
    rest.remove_prefix(units[next].name.size());
    sum += amount * units[next].seconds;
    ++next;
  }
  return sum;
}

// Seconds since the epoch of the modified Julian date, in days of 86 400 s.
std::int64_t day_seconds(const UtcTime& time) {
  double epoch = 0.0;
  double day = 0.0;
  eraCal2jd(time.year, time.month, time.day, &epoch, &day);
  return static_cast<std::int64_t>(day) * kDay_s + time.hour * kHour_s + time.minute * kMinute_s +
         static_cast<std::int64_t>(time.second);
}

UtcTime later(const UtcTime& start, std::int64_t seconds) {
  const std::int64_t of_day =
      start.hour * kHour_s + start.minute * kMinute_s + static_cast<std::int64_t>(start.second) + seconds;
  const std::int64_t days = of_day / kDay_s;
  double epoch = 0.0;
  double day = 0.0;
  eraCal2jd(start.year, start.month, start.day, &epoch, &day);
  UtcTime time;
  double fraction = 0.0;
  eraJd2cal(epoch, day + static_cast<double>(days), &time.year, &time.month, &time.day, &fraction);
  time.hour = static_cast<int>(of_day % kDay_s / kHour_s);
  time.minute = static_cast<int>(of_day % kHour_s / kMinute_s);
  time.second = static_cast<double>(of_day % kMinute_s);
  return time;
}

void require_whole_seconds(const UtcTime& time) {
  if (time.second != std::floor(time.second) || time.second >= 60.0)
    throw InputError("time '{}': must be a whole second, and no leap second, in a series", format_time(time));
}

// How many steps there are from start to end.
std::int64_t steps_of(const TimeSteps& steps) {
  require_whole_seconds(steps.start);
  require_whole_seconds(steps.end);
  if (steps.step_s < 1 || steps.step_s > kLongest_s) refuse_duration(fmt::format("{}s", steps.step_s));
  const std::int64_t span_s = day_seconds(steps.end) - day_seconds(steps.start);
  if (span_s < 0)
    throw InputError("end {} lies before start {}: must not", format_time(steps.end),
                     format_time(steps.start));
  const std::int64_t count = span_s / steps.step_s;
  if (count >= static_cast<std::int64_t>(domain::kMostFrames))
    throw InputError("{} times: must be at most {}", count + 1, domain::kMostFrames);
  return count;
}

}  // namespace

std::int64_t parse_duration_s(const std::string& text) {
  std::string_view rest = text;
  std::int64_t seconds = 0;
  if (rest.starts_with('P')) {
    rest.remove_prefix(1);
    seconds = take_amounts(rest, kIsoDays, text);
    if (rest.starts_with('T')) {
      rest.remove_prefix(1);
      if (rest.empty()) refuse_duration(text);
      seconds += take_amounts(rest, kIsoTimes, text);
    }
  } else {
    seconds = take_amounts(rest, kUnits, text);
  }
  if (!rest.empty() || seconds < 1 || seconds > kLongest_s) refuse_duration(text);
  return seconds;
}

std::string format_duration(std::int64_t seconds) {
  for (const Unit& unit : kUnits)
    if (seconds % unit.seconds == 0) return fmt::format("{}{}", seconds / unit.seconds, unit.name);
  return {};  // not reached: a second divides all
}

TimeSteps parse_time_steps(const std::string& text) {
  const std::vector<std::string> parts = split(text, '/');
  if (parts.size() != 3)
    throw InputError(
        "times '{}': must be START/END/STEP, for example 2024-06-21T04:00Z/2024-06-21T20:00Z/10min", text);
  try {
    const TimeSteps steps{parse_time(parts[0]), parse_time(parts[1]), parse_duration_s(parts[2])};
    steps_of(steps);
    return steps;
  } catch (const InputError& error) {
    throw InputError("times '{}': {}", text, error.what());
  }
}

std::string format_time_steps(const TimeSteps& steps) {
  return fmt::format("{}/{}/{}", format_time(steps.start), format_time(steps.end),
                     format_duration(steps.step_s));
}

std::vector<UtcTime> times_of(const TimeSteps& steps) {
  const std::int64_t last = steps_of(steps);
  std::vector<UtcTime> times;
  times.reserve(static_cast<std::size_t>(last) + 1);
  for (std::int64_t k = 0; k <= last; ++k) times.push_back(later(steps.start, k * steps.step_s));
  return times;
}

std::vector<UtcTime> read_times_csv(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  const std::size_t column = table.column("time");
  if (table.rows() > domain::kMostFrames)
    throw InputError("{}: {} times: must be at most {}", path.string(), table.rows(), domain::kMostFrames);
  std::vector<UtcTime> times;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    try {
      times.push_back(parse_time(table.text(row, column)));
    } catch (const InputError& error) {
      throw InputError("{}: {}", table.place(row), error.what());
    }
  }
  if (times.empty()) throw InputError("{}: no rows: must hold one time or more", path.string());
  return times;
}

}  // namespace skylut
