#include "skylut/export/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

// North at a quarter of the width, east in the middle, columns to the right clockwise. With 8 columns the
// edges between columns 1|2 and 3|4 are north and east.
TEST(LatLong, CompassOfTheColumns) {
  const LatLongProjection projection(4);
  EXPECT_EQ(projection.width(), 8);
  EXPECT_EQ(projection.direction(1, 0).azimuth_deg, 337.5);
  EXPECT_EQ(projection.direction(2, 0).azimuth_deg, 22.5);
  EXPECT_EQ(projection.direction(3, 0).azimuth_deg, 67.5);
  EXPECT_EQ(projection.direction(4, 0).azimuth_deg, 112.5);
  EXPECT_EQ(projection.direction(0, 0).azimuth_deg, 292.5);
}

TEST(LatLong, RowsRunFromZenithToNadirCellCentred) {
  const LatLongProjection projection(4);
  EXPECT_EQ(projection.direction(0, 0).zenith_deg, 22.5);
  EXPECT_EQ(projection.direction(0, 1).zenith_deg, 67.5);
  EXPECT_EQ(projection.direction(0, 3).zenith_deg, 157.5);
}

// In the frame of a program with x to the east, y to the north and z up, the middle of the picture is +x
// and a quarter of the width is +y, as Blender lays out its world textures.
TEST(LatLong, MiddleIsEastQuarterIsNorth) {
  const LatLongProjection projection(512);
  const auto x_y = [&](int column) {
    const Direction direction = projection.direction(column, 256);
    const double azimuth = direction.azimuth_deg * kRadiansPerDegree;
    const double horizontal = std::sin(direction.zenith_deg * kRadiansPerDegree);
    return std::pair{horizontal * std::sin(azimuth), horizontal * std::cos(azimuth)};
  };
  // Half a pixel, 0.18°, off the axis: 1 - cos = 5e-6 twice (zenith and azimuth).
  EXPECT_NEAR(x_y(512).first, 1.0, 1e-5);
  EXPECT_NEAR(x_y(256).second, 1.0, 1e-5);
}

TEST(LatLong, DirectionsAreRowByRow) {
  const LatLongProjection projection(3);
  const std::vector<Direction> directions = projection.directions();
  ASSERT_EQ(directions.size(), 18u);
  EXPECT_EQ(directions[7], projection.direction(1, 1));
}

TEST(Projection, UnknownNamesAndSizesAreRefused) {
  EXPECT_EQ(make_projection("latlong", 16)->name(), "latlong");
  for (const char* name : {"fisheye", "cube", "octahedral", "", "LATLONG"})
    EXPECT_THROW(make_projection(name, 16), InputError) << name;
  EXPECT_THROW(LatLongProjection(1), InputError);
  EXPECT_THROW(LatLongProjection(8193), InputError);
}

}  // namespace
}  // namespace skylut
