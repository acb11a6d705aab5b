#include "skylut/site/sun_series.hpp"

#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

void check_count(const char* what, std::size_t count) {
  if (count < 1 || count > domain::kMostFrames)
    throw InputError("series of {} {}: must have 1 to {}", count, what, domain::kMostFrames);
}

void add(SunSeries& series, SunFrame frame) {
  if (!domain::kSunZenith_deg.holds(frame.sun.zenith_deg)) {
    ++series.too_dark;
    return;
  }
  frame.index = series.frames.size() + 1;
  series.frames.push_back(frame);
}

}  // namespace

SunSeries sun_series(const Place& place, std::span<const UtcTime> times) {
  check_count("times", times.size());
  SunSeries series;
  for (const UtcTime& time : times)
    add(series, {0, time, sun_direction(place, time), earth_sun_distance_au(time)});
  return series;
}

SunSeries sun_series(std::span<const Direction> suns, double sun_distance_au) {
  check_count("suns", suns.size());
  SunSeries series;
  for (const Direction& sun : suns) add(series, {0, std::nullopt, sun, sun_distance_au});
  return series;
}

}  // namespace skylut
