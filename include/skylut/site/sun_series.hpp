#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "skylut/core/directions.hpp"
#include "skylut/site/place.hpp"
#include "skylut/site/sun.hpp"

namespace skylut {

/// One sun of a series.
struct SunFrame {
  std::size_t index = 1;  ///< among the series' frames, from 1 without gaps
  std::optional<UtcTime> time;
  Direction sun;
  double sun_distance_au = 1.0;

  bool operator==(const SunFrame&) const = default;
};

/// Suns one after the other, for a sequence of skies.
struct SunSeries {
  std::vector<SunFrame> frames;
  std::size_t too_dark = 0;  ///< suns more than 99° from the zenith (night), which have no frame
};

/// The sun over a place at each time, with its distance then.
/// @param times  in any order, which the frames keep
/// @throws InputError  for a place or time out of range, none or more than 100 000 times
SunSeries sun_series(const Place& place, std::span<const UtcTime> times);

/// Suns by their angles, all at one distance.
/// @throws InputError  none or more than 100 000 suns
SunSeries sun_series(std::span<const Direction> suns, double sun_distance_au);

}  // namespace skylut
