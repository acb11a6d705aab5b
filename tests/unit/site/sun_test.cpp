#include "skylut/site/sun.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_time(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Reda and Andreas 2008 (NREL/TP-560-34302), appendix A.5, states the topocentric elevation without
// refraction e0 = 39.872046° and the azimuth 194.340241° for UT1 = UTC, as here. Its own accuracy is
// 0.0003°; it differs from ERFA's full theory by less than that.
TEST(Sun, SolarPositionAlgorithmExample) {
  const Direction sun =
      sun_direction({39.742476, -105.1786, 1830.14}, parse_time("2003-10-17T12:30:30-07:00"));
  EXPECT_NEAR(sun.zenith_deg, 90.0 - 39.872046, 3e-4);
  EXPECT_NEAR(sun.azimuth_deg, 194.340241, 4e-4);
}

// Meeus, Astronomical Algorithms, example 25.b: 1992 October 13.0 TD, apparent right ascension
// 13h13m30.749s, declination -7°47'01.74", and with the whole VSOP87 theory a distance of 0.99760853 au. Seen
// from the north pole, the zenith angle is 90° - declination, less the parallax in altitude 8.794" cos δ /
// 0.9976.
TEST(Sun, MeeusExample) {
  // TD - UTC was 59.184 s (27 leap seconds by then: TAI - UTC = 27 s).
  const UtcTime time = parse_time("1992-10-12T23:59:00.816Z");
  const double declination_deg = -(7.0 + 47.0 / 60.0 + 1.74 / 3600.0);
  const double parallax_deg = 8.794 / 3600.0 * std::cos(declination_deg * M_PI / 180.0) / 0.99760853;
  EXPECT_NEAR(sun_direction({90.0, 0.0, 0.0}, time).zenith_deg, 90.0 - declination_deg + parallax_deg, 5e-5);
  EXPECT_NEAR(earth_sun_distance_au(time), 0.99760853, 2e-8);
}

// U.S. Naval Observatory: equinox 2024 March 20 03:06 UTC, solstice 2024 June 20 20:51 UTC. At the
// equinox the sun stands on the equator (moving 0.0165° an hour: a minute is 3e-4°); at the solstice
// its declination is the true obliquity, 23.4361° + nutation 0.0025°.
TEST(Sun, EquinoxAndSolstice) {
  const Place pole{90.0, 0.0, 0.0};
  const double parallax_deg = 8.794 / 3600.0;
  EXPECT_NEAR(sun_direction(pole, parse_time("2024-03-20T03:06Z")).zenith_deg - parallax_deg, 90.0, 3e-4);
  EXPECT_NEAR(sun_direction(pole, parse_time("2024-06-20T20:51Z")).zenith_deg - parallax_deg, 90.0 - 23.4385,
              5e-3);
}

// At true noon the sun is due south (north of the tropic), highest, and equally high an hour angle
// before and after; the declination moves it by up to 0.017° an hour.
TEST(Sun, NoonIsTheMiddleOfTheDay) {
  const Place place{45.0, 0.0, 0.0};
  // Equation of time on 2024 September 1: within a minute of 0, so transit near 12:00 UTC.
  const double noon_azimuth = sun_direction(place, parse_time("2024-09-01T12:00:00Z")).azimuth_deg;
  EXPECT_NEAR(noon_azimuth, 180.0, 0.5);
  const Direction morning = sun_direction(place, parse_time("2024-09-01T09:00:00Z"));
  const Direction evening = sun_direction(place, parse_time("2024-09-01T15:00:00Z"));
  EXPECT_LT(morning.azimuth_deg, 180.0);
  EXPECT_GT(evening.azimuth_deg, 180.0);
  EXPECT_NEAR(morning.zenith_deg, evening.zenith_deg, 0.2);
}

TEST(Sun, DistanceAtPerihelionAndAphelion) {
  // USNO: perihelion 2024 January 3 at 0.98331 au, aphelion July 5 at 1.01673 au.
  EXPECT_NEAR(earth_sun_distance_au(parse_time("2024-01-03T01:00Z")), 0.98331, 1e-5);
  EXPECT_NEAR(earth_sun_distance_au(parse_time("2024-07-05T05:00Z")), 1.01673, 1e-5);
}

TEST(Time, ZonesAreOneMoment) {
  const UtcTime expected{2003, 10, 17, 19, 30, 30.0};
  for (const char* text : {"2003-10-17T19:30:30Z", "2003-10-17T12:30:30-07:00", "2003-10-17 12:30:30-0700",
                           "2003-10-18T05:00:30+09:30", "2003-10-17t12:30:30-07"})
    EXPECT_EQ(parse_time(text), expected) << text;
  EXPECT_EQ(parse_time("2024-12-31T20:00-05:00"), (UtcTime{2025, 1, 1, 1, 0, 0.0}));
  EXPECT_EQ(parse_time("2024-03-01T00:30+01:00"), (UtcTime{2024, 2, 29, 23, 30, 0.0}));
  EXPECT_EQ(format_time(parse_time("2003-10-17T12:30:05.25-07:00")), "2003-10-17T19:30:05.25Z");
  EXPECT_EQ(format_time(expected), "2003-10-17T19:30:30Z");
}

TEST(Time, LeapSecond) {
  EXPECT_EQ(parse_time("2016-12-31T23:59:60Z").second, 60.0);
  EXPECT_THROW(parse_time("2016-12-30T23:59:60Z"), InputError);
}

TEST(Time, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("2026-06-21T12:00"),
            "time '2026-06-21T12:00': has no zone; expected ISO 8601 with a zone, for example "
            "2026-06-21T12:00:00Z or "
            "2026-06-21T14:00+02:00");
  for (const char* text :
       {"", "noon", "2026-06-21", "2026-02-29T12:00Z", "2026-13-01T12:00Z", "2026-06-21T24:00Z",
        "2026-06-21T12:60Z", "2026-06-21T12:00:61Z", "2026-06-21T12:00+15:00", "2026-06-21T12:00Zulu",
        "2026-06-21T12:00:1Z", "2026-06-21T12:00:10.Z", "1900-01-01T00:00Z", "26-06-21T12:00Z"})
    EXPECT_NE(refusal(text), "") << text;
  EXPECT_THROW(sun_direction({}, {2026, 2, 30, 0, 0, 0.0}), InputError);
}

// A day stands for its noon.
TEST(Sun, ADateAlone) {
  EXPECT_EQ(parse_date("2024-02-29"), parse_time("2024-02-29T12:00Z"));
  for (const char* text :
       {"2024-02-30", "2023-02-29", "1959-12-31", "2024-6-21", "2024-06-21T12:00Z", "today", ""})
    EXPECT_THROW(parse_date(text), InputError) << text;
}

}  // namespace
}  // namespace skylut
