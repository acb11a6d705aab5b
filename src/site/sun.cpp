#include "skylut/site/sun.hpp"

#include <erfa.h>
#include <erfam.h>
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "place_range.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr int kFirstYear = 1960;  // UTC begins
constexpr int kLastYear = 2100;   // end of the Earth ephemeris' tested span

[[noreturn]] void refuse(const std::string& text, const char* why) {
  throw InputError(
      "time '{}': {}; expected ISO 8601 with a zone, for example 2026-06-21T12:00:00Z or "
      "2026-06-21T14:00+02:00",
      text, why);
}

// Takes the pieces of a time off the front of a text.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text), rest_(text) {}

  bool take(char letter) {
    if (rest_.empty() || rest_.front() != letter) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void require(char letter) {
    if (!take(letter)) refuse(text_, "is no such time");
  }
  int digits(std::size_t count) {
    if (rest_.size() < count || rest_.find_first_not_of("0123456789") < count)
      refuse(text_, "is no such time");
    int value = 0;
    std::from_chars(rest_.data(), rest_.data() + count, value);
    rest_.remove_prefix(count);
    return value;
  }
  double seconds() {
    double value = digits(2);
    if (!take('.')) return value;
    const std::size_t count = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    if (count == 0) refuse(text_, "is no such time");
    double fraction = 0.0;
    const std::string decimal = "0." + std::string(rest_.substr(0, count));
    std::from_chars(decimal.data(), decimal.data() + decimal.size(), fraction);
    rest_.remove_prefix(count);
    return value + fraction;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  const std::string& text_;
  std::string_view rest_;
};

struct JulianDate {
  double day;
  double fraction;
};

// Quasi-Julian date of ERFA: a day with a leap second is longer, so that no moment is ambiguous.
JulianDate utc_julian_date(const UtcTime& time) {
  JulianDate date{};
  const int status = eraDtf2d("UTC", time.year, time.month, time.day, time.hour, time.minute, time.second,
                              &date.day, &date.fraction);
  // +1 warns of leap seconds that are not announced yet; +2 of seconds past the end of the day.
  if (status < 0 || status > 1 || time.year < kFirstYear || time.year > kLastYear)
    throw InputError("time {}: no such moment in UTC; expected a date of the years {}-{}", format_time(time),
                     kFirstYear, kLastYear);
  return date;
}

JulianDate terrestrial_time(const JulianDate& utc) {
  JulianDate atomic{};
  JulianDate terrestrial{};
  eraUtctai(utc.day, utc.fraction, &atomic.day, &atomic.fraction);
  eraTaitt(atomic.day, atomic.fraction, &terrestrial.day, &terrestrial.fraction);
  return terrestrial;
}

// Barycentric position of the sun, au. Terrestrial time stands for TDB: they differ by < 2 ms.
void sun_position(const JulianDate& time, double earlier_days, double position[3]) {
  double heliocentric[2][3];
  double barycentric[2][3];
  eraEpv00(time.day, time.fraction - earlier_days, heliocentric, barycentric);
  eraPmp(barycentric[0], heliocentric[0], position);
}

}  // namespace

UtcTime parse_time(const std::string& text) {
  Scanner scanner(text);
  UtcTime local;
  local.year = scanner.digits(4);
  scanner.require('-');
  local.month = scanner.digits(2);
  scanner.require('-');
  local.day = scanner.digits(2);
  if (!scanner.take('T') && !scanner.take('t') && !scanner.take(' ')) refuse(text, "has no time of day");
  local.hour = scanner.digits(2);
  scanner.require(':');
  local.minute = scanner.digits(2);
  if (scanner.take(':')) local.second = scanner.seconds();
  if (scanner.at_end()) refuse(text, "has no zone");

  int offset_minutes = 0;
  if (!scanner.take('Z') && !scanner.take('z')) {
    const int sign = scanner.take('-') ? -1 : 1;
    if (sign > 0) scanner.require('+');
    const int hours = scanner.digits(2);
    const bool colon = scanner.take(':');
    const int minutes = colon || !scanner.at_end() ? scanner.digits(2) : 0;
    if (hours > 14 || minutes > 59) refuse(text, "has an impossible zone");
    offset_minutes = sign * (60 * hours + minutes);
  }
  if (!scanner.at_end()) refuse(text, "is no such time");
  if (local.year < kFirstYear || local.year > kLastYear) refuse(text, "is outside the years 1960-2100");
  if (local.hour > 23 || local.minute > 59 || local.second >= 61.0) refuse(text, "is no time of day");

  double day = 0.0;
  double midnight = 0.0;
  if (eraCal2jd(local.year, local.month, local.day, &day, &midnight) != 0)
    refuse(text, "is no day of the calendar");
  const int minutes = 60 * local.hour + local.minute - offset_minutes;
  const int days = static_cast<int>(std::floor(minutes / 1440.0));
  UtcTime utc;
  double fraction = 0.0;
  eraJd2cal(day, midnight + days, &utc.year, &utc.month, &utc.day, &fraction);
  utc.hour = (minutes - 1440 * days) / 60;
  utc.minute = (minutes - 1440 * days) % 60;
  utc.second = local.second;
  if (utc.second >= 60.0) utc_julian_date(utc);
  return utc;
}

UtcTime parse_date(const std::string& text) {
  constexpr std::size_t kLength = 10;  // YYYY-MM-DD
  try {
    if (text.size() == kLength) return parse_time(text + "T12:00Z");
  } catch (const InputError&) {
    // What parse_time refuses is no day either; it would name the time, too.
  }
  throw InputError("date '{}': must be a day of the years {}-{}, for example 2026-06-21", text, kFirstYear,
                   kLastYear);
}

std::string format_time(const UtcTime& time) {
  const std::string date =
      fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:", time.year, time.month, time.day, time.hour, time.minute);
  if (time.second == std::floor(time.second)) return fmt::format("{}{:02.0f}Z", date, time.second);
  return fmt::format("{}{}{}Z", date, time.second < 10.0 ? "0" : "", time.second);
}

Direction sun_direction(const Place& place, const UtcTime& time) {
  check_place(place);
  const JulianDate utc = utc_julian_date(time);
  const JulianDate terrestrial = terrestrial_time(utc);

  // No pressure, no refraction: the astrometric context then holds only geometry.
  eraASTROM context;
  double equation_of_origins = 0.0;
  eraApco13(utc.day, utc.fraction, 0.0, place.longitude_deg * kRadiansPerDegree,
            place.latitude_deg * kRadiansPerDegree, place.height_m, 0.0, 0.0, 0.0, 0.0, 0.0, 0.55, &context,
            &equation_of_origins);

  // From the observer now to the sun when the light left it: parallax and light time.
  double sun[3];
  double line_of_sight[3];
  double light_days = 0.0;
  for (int pass = 0; pass < 3; ++pass) {
    sun_position(terrestrial, light_days, sun);
    eraPmp(sun, context.eb, line_of_sight);
    light_days = eraPm(line_of_sight) * ERFA_AULT / ERFA_DAYSEC;
  }
  double right_ascension = 0.0;
  double declination = 0.0;
  eraC2s(line_of_sight, &right_ascension, &declination);

  double intermediate_ra = 0.0;
  double intermediate_dec = 0.0;
  eraAtciqz(right_ascension, declination, &context, &intermediate_ra, &intermediate_dec);
  double azimuth = 0.0;
  double zenith = 0.0;
  double hour_angle = 0.0;
  double observed_dec = 0.0;
  double observed_ra = 0.0;
  eraAtioq(intermediate_ra, intermediate_dec, &context, &azimuth, &zenith, &hour_angle, &observed_dec,
           &observed_ra);
  return {zenith * kDegreesPerRadian, eraAnp(azimuth) * kDegreesPerRadian};
}

double earth_sun_distance_au(const UtcTime& time) {
  const JulianDate terrestrial = terrestrial_time(utc_julian_date(time));
  double heliocentric[2][3];
  double barycentric[2][3];
  eraEpv00(terrestrial.day, terrestrial.fraction, heliocentric, barycentric);
  return eraPm(heliocentric[0]);
}

}  // namespace skylut
