#include "geometry/shell_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace skylut::transfer {
namespace {

const std::vector<double> kLevels_km = {0.0, 1.0, 3.0, 10.0, 40.0, 100.0};

double total(const std::vector<double>& length_km) {
  return std::accumulate(length_km.begin(), length_km.end(), 0.0);
}

/// √(r_h² - p²) in long double, h and the closest altitude above the ground of radius R.
double from_closest(double planet_km, double h_km, double closest_km) {
  const long double difference = static_cast<long double>(h_km) - closest_km;
  return static_cast<double>(
      std::sqrt(difference * (2.0L * planet_km + static_cast<long double>(h_km) + closest_km)));
}

class ShellGeometryOfPlanet : public testing::TestWithParam<double> {
 protected:
  ShellGeometry shells{kLevels_km, GetParam()};
  std::vector<double> length_km;
};

// Straight up: the thickness of every layer, and of the part of the layer above the start.
TEST_P(ShellGeometryOfPlanet, VerticalRaysCrossTheThickness) {
  ASSERT_TRUE(shells.path_to_top(0.0, 1.0, length_km));
  // r² - p² for p = 0 rounds to 1e-16 r², that is 1e-16 r of a length.
  const double rounding = 1e-15 * (GetParam() + 100.0);
  for (std::size_t i = 0; i < length_km.size(); ++i)
    EXPECT_NEAR(length_km[i], kLevels_km[i + 1] - kLevels_km[i], rounding);
  ASSERT_TRUE(shells.path_to_top(2.0, 1.0, length_km));
  EXPECT_EQ(length_km[0], 0.0);
  EXPECT_NEAR(length_km[1], 1.0, rounding);
  EXPECT_NEAR(total(length_km), 98.0, rounding);
}

// Horizontally: √((R+h)² - R²) to every level.
TEST_P(ShellGeometryOfPlanet, HorizontalRaysAreHalfChords) {
  for (const double altitude : {0.0, 3.0, 5.0}) {
    ASSERT_TRUE(shells.path_to_top(altitude, 0.0, length_km));
    double sum = 0.0;
    for (std::size_t i = 0; i < length_km.size(); ++i) {
      sum += length_km[i];
      const double expected =
          kLevels_km[i + 1] > altitude ? from_closest(GetParam(), kLevels_km[i + 1], altitude) : 0.0;
      EXPECT_NEAR(sum, expected, 1e-12 * (1.0 + expected)) << altitude << " " << i;
    }
  }
}

// Down through a lowest point at 2 km: the layers between it and the start are crossed twice.
TEST_P(ShellGeometryOfPlanet, LimbRaysCrossTheLowerLayersTwice) {
  const double planet = GetParam();
  const double start = 40.0;
  const double lowest = 2.0;
  const double cosine = -from_closest(planet, start, lowest) / (planet + start);
  ASSERT_TRUE(shells.path_to_top(start, cosine, length_km));
  EXPECT_EQ(length_km[0], 0.0);
  const double to_3 = from_closest(planet, 3.0, lowest);
  const double to_10 = from_closest(planet, 10.0, lowest);
  const double to_40 = from_closest(planet, 40.0, lowest);
  const double to_100 = from_closest(planet, 100.0, lowest);
  // (r cos)² is known to a few 1e-16 r²; an error e of s² moves s by e/2s, most at the smallest s.
  const double tolerance = 1e-11 + 1e-15 * (planet + start) * (planet + start) / to_3;
  EXPECT_NEAR(length_km[1], 2.0 * to_3, tolerance);
  EXPECT_NEAR(length_km[2], 2.0 * (to_10 - to_3), tolerance);
  EXPECT_NEAR(length_km[3], 2.0 * (to_40 - to_10), tolerance);
  EXPECT_NEAR(length_km[4], to_100 - to_40, tolerance);
}

TEST_P(ShellGeometryOfPlanet, TheGroundBlocks) {
  length_km = {-1.0};
  const double horizon = -from_closest(GetParam(), 10.0, 0.0) / (GetParam() + 10.0);
  EXPECT_FALSE(shells.path_to_top(10.0, -1.0, length_km));
  EXPECT_FALSE(shells.path_to_top(10.0, horizon * 1.0001, length_km));
  EXPECT_FALSE(shells.path_to_top(0.0, -1e-9, length_km));
  EXPECT_EQ(length_km, std::vector<double>{-1.0});  // untouched
  EXPECT_TRUE(shells.path_to_top(10.0, horizon * 0.9999, length_km));
  EXPECT_TRUE(shells.path_to_top(0.0, 0.0, length_km));
}

TEST_P(ShellGeometryOfPlanet, SlantRaysFollowTheCosineLaw) {
  const double planet = GetParam();
  for (const double cosine : {0.9, 0.3, 0.05}) {
    ASSERT_TRUE(shells.path_to_top(1.0, cosine, length_km));
    const long double r = static_cast<long double>(planet) + 1.0L;
    const long double along = r * cosine;
    const long double gained = 99.0L * (2.0L * planet + 101.0L);
    const auto expected = static_cast<double>(gained / (std::sqrt(along * along + gained) + along));
    // √(along² + …) - along loses the digits of along against the path.
    EXPECT_NEAR(total(length_km), expected, 4e-16 * (planet + expected)) << cosine;
  }
}

INSTANTIATE_TEST_SUITE_P(Planets, ShellGeometryOfPlanet, testing::Values(100.0, 3390.0, 6371.0, 6.4e7));

TEST(ShellGeometry, LayersHoldTheirLowerLevel) {
  const ShellGeometry shells(kLevels_km, 6371.0);
  EXPECT_EQ(shells.layer_of(0.0), 0);
  EXPECT_EQ(shells.layer_of(0.999), 0);
  EXPECT_EQ(shells.layer_of(1.0), 1);
  EXPECT_EQ(shells.layer_of(99.0), 4);
  EXPECT_EQ(shells.layer_of(100.0), 4);
}

}  // namespace
}  // namespace skylut::transfer
