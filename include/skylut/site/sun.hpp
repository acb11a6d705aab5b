#pragma once

#include <string>

#include "skylut/core/directions.hpp"
#include "skylut/site/place.hpp"

namespace skylut {

/// A moment in Coordinated Universal Time, Gregorian calendar.
struct UtcTime {
  int year = 2000;
  int month = 1;        ///< 1-12
  int day = 1;          ///< 1-31
  int hour = 0;         ///< 0-23
  int minute = 0;       ///< 0-59
  double second = 0.0;  ///< [0, 61): 60 only within a leap second

  bool operator==(const UtcTime&) const = default;
};

/// Reads an ISO 8601 date and time with its zone: "2003-10-17T12:30:30-07:00", "2026-06-21T12:00Z".
/// A blank may stand for the T; seconds may be left out or carry a fraction. Years 1960-2100.
/// @throws InputError  naming the text and what would be right: not such a time, no zone (local time
///                     would be a guess), no such day
UtcTime parse_time(const std::string& text);

/// Reads a day of the calendar, "2026-06-21": its noon in UTC. Years 1960-2100.
/// @throws InputError  naming the text and what would be right
UtcTime parse_date(const std::string& text);

/// Writes a time as parse_time reads it, in UTC, with whole seconds unless there is a fraction.
std::string format_time(const UtcTime& time);

/// Direction of the sun's centre as it would be seen from the place without air: topocentric true
/// zenith angle (no refraction) from the ellipsoid's normal, and azimuth clockwise from north.
/// IAU 2006/2000A by ERFA, with light time, aberration and parallax; UT1 - UTC (|.| < 0.9 s) and polar
/// motion are taken as 0, which moves the sun by less than 0.004°. Earth ephemeris of ERFA (5e-6°).
/// @throws InputError  for a place or time out of range
Direction sun_direction(const Place& place, const UtcTime& time);

/// Distance between the centres of Earth and sun, astronomical units (0.983-1.017).
/// Irradiance falls as its inverse square.
double earth_sun_distance_au(const UtcTime& time);

}  // namespace skylut
