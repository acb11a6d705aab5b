#include "skylut/core/directions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

TEST(Directions, Utm271IsZenithAndNineRingsOfThirty) {
  const auto directions = directions_utm271();
  ASSERT_EQ(directions.size(), 271u);
  EXPECT_EQ(directions[0], (Direction{0.0, 0.0}));
  EXPECT_EQ(directions[1], (Direction{10.0, 0.0}));
  EXPECT_EQ(directions[270], (Direction{90.0, 348.0}));
}

// Equal solid angles: the mean of cos θ over the hemisphere is 1/2.
TEST(Directions, Preetham343CoversTheHemisphereEvenly) {
  const auto directions = directions_preetham343();
  ASSERT_EQ(directions.size(), 343u);
  double sum = 0.0;
  for (const Direction& direction : directions) sum += std::cos(direction.zenith_deg * kRadiansPerDegree);
  EXPECT_NEAR(sum / 343.0, 0.5, 2e-3);
}

TEST(Directions, AngleBetweenKnownDirections) {
  EXPECT_NEAR(angle_between({0.0, 0.0}, {45.0, 123.0}), 45.0 * kRadiansPerDegree, 1e-14);
  EXPECT_NEAR(angle_between({90.0, 10.0}, {90.0, 190.0}), kPi, 1e-7);
  // cos γ = cos θ₁ cos θ₂ + sin θ₁ sin θ₂ cos Δφ = 1/2 for θ = 45°, Δφ = 90°.
  EXPECT_NEAR(angle_between({45.0, 0.0}, {45.0, 90.0}), kPi / 3.0, 1e-14);
  // The difference of 30° and 30.0000001° carries the rounding of 30, 3.6e-15°.
  EXPECT_NEAR(angle_between({30.0, 0.0}, {30.0 + 1e-7, 0.0}), 1e-7 * kRadiansPerDegree,
              8e-15 * kRadiansPerDegree);
}

TEST(Directions, MirrorSunsSeeTheSameRelativeAzimuths) {
  std::multiset<double> east;
  std::multiset<double> west;
  for (const Direction& direction : directions_utm271()) {
    east.insert(folded_relative_azimuth_deg(direction.azimuth_deg, 90.0));
    west.insert(folded_relative_azimuth_deg(direction.azimuth_deg, 270.0));
  }
  EXPECT_EQ(east, west);
  EXPECT_DOUBLE_EQ(folded_relative_azimuth_deg(350.0, 20.0), 30.0);
}

}  // namespace
}  // namespace skylut
