#include "skylut/site/sun_series.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"
#include "skylut/site/time_steps.hpp"

namespace skylut {
namespace {

const Place kParis{48.85, 2.35, 35.0};

TEST(SunSeries, IsTheSunAtEveryTime) {
  const auto times = times_of(parse_time_steps("2024-06-21T06:00Z/2024-06-21T18:00Z/6h"));
  const SunSeries series = sun_series(kParis, times);
  ASSERT_EQ(series.frames.size(), 3U);
  EXPECT_EQ(series.too_dark, 0U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(series.frames[k].index, k + 1);
    EXPECT_EQ(series.frames[k].time, times[k]);
    EXPECT_EQ(series.frames[k].sun, sun_direction(kParis, times[k]));
    EXPECT_EQ(series.frames[k].sun_distance_au, earth_sun_distance_au(times[k]));
  }
}

// At 48.85° N the equinox day has 12 h of sun and 2 × 55 min or so of twilight: 13.8 h above -9°.
TEST(SunSeries, NightHasNoFramesAndIsCounted) {
  const SunSeries series =
      sun_series(kParis, times_of(parse_time_steps("2024-03-20T00:00Z/2024-03-20T23:50Z/10min")));
  EXPECT_EQ(series.frames.size() + series.too_dark, 144U);
  EXPECT_NEAR(static_cast<double>(series.frames.size()), 13.8 * 6.0, 2.0);
  for (std::size_t k = 0; k < series.frames.size(); ++k) {
    EXPECT_LE(series.frames[k].sun.zenith_deg, 99.0);
    EXPECT_EQ(series.frames[k].index, k + 1);
  }
}

TEST(SunSeries, OfAngles) {
  const std::vector<Direction> suns{{30.0, 90.0}, {96.0, 100.0}, {100.0, 110.0}, {45.0, 120.0}};
  const SunSeries series = sun_series(suns, 0.99);
  ASSERT_EQ(series.frames.size(), 3U);
  EXPECT_EQ(series.too_dark, 1U);
  EXPECT_EQ(series.frames[2], (SunFrame{3, std::nullopt, {45.0, 120.0}, 0.99}));
}

TEST(SunSeries, RefusesNoneAndTooMany) {
  EXPECT_THROW(sun_series(kParis, {}), InputError);
  EXPECT_THROW(sun_series({}, 1.0), InputError);
  const std::vector<Direction> many(100001, Direction{45.0, 0.0});
  EXPECT_THROW(sun_series(many, 1.0), InputError);
}

}  // namespace
}  // namespace skylut
