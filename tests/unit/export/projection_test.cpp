#include "skylut/export/projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

std::unique_ptr<Projection> one(const std::string& name, int size, std::optional<SkyPart> part = {}) {
  return std::move(make_projections({name, size, part}).front());
}

double solid_angle_of(const std::vector<std::unique_ptr<Projection>>& pictures) {
  double sum = 0.0;
  for (const auto& picture : pictures)
    for (int row = 0; row < picture->height(); ++row)
      for (int column = 0; column < picture->width(); ++column) sum += picture->solid_angle_sr(column, row);
  return sum;
}

void expect_direction(const Projection& picture, double x, double y, const Direction& expected) {
  const auto direction = picture.direction_at(x, y);
  ASSERT_TRUE(direction) << x << ", " << y;
  EXPECT_NEAR(angle_between(*direction, expected) * kDegreesPerRadian, 0.0, 1e-5)
      << picture.name() << " at " << x << ", " << y << ": " << direction->zenith_deg << ", "
      << direction->azimuth_deg;
}

// North at a quarter of the width, east in the middle, columns to the right clockwise.
TEST(LatLong, CompassOfTheColumnsRowsFromZenithToNadir) {
  const auto projection = one("latlong", 4);
  EXPECT_EQ(projection->width(), 8);
  EXPECT_EQ(projection->direction(1, 0)->azimuth_deg, 337.5);
  EXPECT_EQ(projection->direction(2, 0)->azimuth_deg, 22.5);
  EXPECT_EQ(projection->direction(3, 0)->azimuth_deg, 67.5);
  EXPECT_EQ(projection->direction(4, 0)->azimuth_deg, 112.5);
  EXPECT_EQ(projection->direction(0, 0)->azimuth_deg, 292.5);
  EXPECT_EQ(projection->direction(0, 0)->zenith_deg, 22.5);
  EXPECT_EQ(projection->direction(0, 1)->zenith_deg, 67.5);
  EXPECT_EQ(projection->direction(0, 3)->zenith_deg, 157.5);
}

TEST(LatLong, AHemisphereEndsAtTheHorizon) {
  const auto projection = one("latlong", 4, SkyPart::hemisphere);
  EXPECT_EQ(projection->width(), 16);
  EXPECT_EQ(projection->direction(3, 3)->zenith_deg, 78.75);
  expect_direction(*projection, 8, 4, {90, 90});
  expect_direction(*projection, 4, 4, {90, 0});
}

// As an observer lying on his back with his head to the north sees it.
TEST(Fisheye, LookingUpEastIsAtTheLeft) {
  for (const char* name : {"fisheye", "fisheye-equisolid"}) {
    const auto half = one(name, 8);
    expect_direction(*half, 4, 4, {0, 0});
    expect_direction(*half, 4, 0, {90, 0});
    expect_direction(*half, 0, 4, {90, 90});
    expect_direction(*half, 4, 8, {90, 180});
    expect_direction(*half, 8, 4, {90, 270});
    EXPECT_FALSE(half->direction(0, 0));
    EXPECT_EQ(half->solid_angle_sr(0, 0), 0.0);
    expect_direction(*one(name, 8, SkyPart::sphere), 4, 0, {180, 0});
  }
}

TEST(Fisheye, RadiusAndZenithAngle) {
  expect_direction(*one("fisheye", 8), 4, 2, {45, 0});
  expect_direction(*one("fisheye", 8, SkyPart::sphere), 4, 2, {90, 0});
  expect_direction(*one("fisheye-equisolid", 8), 4, 2,
                   {2 * std::asin(0.5 * std::sqrt(0.5)) * kDegreesPerRadian, 0});
  expect_direction(*one("fisheye-equisolid", 8, SkyPart::sphere), 4, 2, {60, 0});
}

// Every face by its middle, its right edge and its upper edge; table 8.19 of the OpenGL 4.6 specification
// with x = west, y = up, z = south: sc grows to the right, tc downwards.
TEST(Cube, FacesAreThoseOfOpenGl) {
  const Direction up{0, 0};
  const Direction down{180, 0};
  const Direction north{90, 0};
  const Direction east{90, 90};
  const Direction south{90, 180};
  const Direction west{90, 270};
  struct Expected {
    const char* face;
    Direction middle;
    Direction right;
    Direction top;
  };
  const std::vector<Expected> expected{{"px", west, north, up}, {"nx", east, south, up},
                                       {"py", up, west, north}, {"ny", down, west, south},
                                       {"pz", south, west, up}, {"nz", north, east, up}};
  const auto faces = make_projections({"cube", 4, {}});
  ASSERT_EQ(faces.size(), 6u);
  const auto midway = [](const Direction& a, const Direction& b, const Projection& face, double x, double y) {
    const auto edge = face.direction_at(x, y);
    EXPECT_NEAR(angle_between(*edge, a), kPi / 4, 1e-12);
    EXPECT_NEAR(angle_between(*edge, b), kPi / 4, 1e-12);
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const Projection& face = *faces[i];
    EXPECT_EQ(face.face(), expected[i].face);
    expect_direction(face, 2, 2, expected[i].middle);
    midway(expected[i].middle, expected[i].right, face, 4, 2);
    midway(expected[i].middle, expected[i].top, face, 2, 0);
  }
}

TEST(Cube, TheCrossHasTheFacesWithoutSeams) {
  const auto cross = one("cube-cross", 4);
  EXPECT_EQ(cross->width(), 16);
  EXPECT_EQ(cross->height(), 12);
  expect_direction(*cross, 2, 6, {90, 90});
  expect_direction(*cross, 6, 6, {90, 180});
  expect_direction(*cross, 10, 6, {90, 270});
  expect_direction(*cross, 14, 6, {90, 0});
  expect_direction(*cross, 6, 2, {0, 0});
  expect_direction(*cross, 6, 10, {180, 0});
  EXPECT_FALSE(cross->direction_at(2, 2));
  EXPECT_TRUE(cross->direction_at(16, 6));
  const auto no_seam = [&](double x1, double y1, double x2, double y2) {
    EXPECT_LT(angle_between(*cross->direction_at(x1, y1), *cross->direction_at(x2, y2)), 1e-6);
  };
  for (const double x : {4.0, 8.0, 12.0}) no_seam(x - 1e-7, 5.3, x + 1e-7, 5.3);
  for (const double y : {4.0, 8.0}) no_seam(5.3, y - 1e-7, 5.3, y + 1e-7);
}

// pbrt-v4's frame: x to the right, y downwards, z up in the middle; Clarberg's figure 3.
TEST(Octahedral, MiddleEdgesAndCorners) {
  const auto square = one("octahedral", 8);
  expect_direction(*square, 4, 4, {0, 0});
  expect_direction(*square, 8, 4, {90, 90});
  expect_direction(*square, 4, 8, {90, 0});
  expect_direction(*square, 0, 4, {90, 270});
  expect_direction(*square, 4, 0, {90, 180});
  for (const double corner : {0.0, 8.0}) expect_direction(*square, corner, corner, {180, 0});
  // Half way to the corner of the square the diamond has its edge: the horizon.
  expect_direction(*square, 6, 6, {90, 45});
  // |z| = 1 - r² with r = 1/2.
  expect_direction(*square, 6, 4, {std::acos(0.75) * kDegreesPerRadian, 90});
}

// The sum over a picture is the whole. Pixels cut by the circle of a fisheye are quadratures: see the header.
TEST(Projections, PixelsFillTheSphere) {
  for (const std::string& name : projection_names())
    for (const int size : {2, 5, 64})
      EXPECT_NEAR(solid_angle_of(make_projections({name, size, SkyPart::sphere})) / (4 * kPi), 1.0,
                  size < 10 ? 1e-6 : 1e-9)
          << name << " " << size;
  for (const char* name : {"latlong", "fisheye", "fisheye-equisolid"})
    for (const int size : {2, 5, 64})
      EXPECT_NEAR(solid_angle_of(make_projections({name, size, SkyPart::hemisphere})) / (2 * kPi), 1.0,
                  size < 10 ? 1e-6 : 1e-9)
          << name << " " << size;
}

// The density at a pixel's middle against its solid angle and against the triangle of three near directions.
TEST(Projections, DensityIsTheSolidAngleOfASmallPart) {
  constexpr double kStep = 1e-4;
  for (const std::string& name : projection_names()) {
    const auto picture = one(name, 64);
    const int column = picture->width() * 3 / 8 + 2;
    const int row = picture->height() * 3 / 8 + 1;
    const double x = column + 0.5;
    const double y = row + 0.5;
    const auto at = picture->direction_at(x, y);
    ASSERT_TRUE(at) << name;
    EXPECT_NEAR(picture->solid_angle_sr(column, row) / picture->density_sr(x, y), 1.0, 1e-2) << name;
    const auto cartesian = [&](double dx, double dy) {
      const auto direction = *picture->direction_at(x + dx, y + dy);
      const double zenith = direction.zenith_deg * kRadiansPerDegree;
      const double azimuth = direction.azimuth_deg * kRadiansPerDegree;
      return std::array{std::sin(zenith) * std::sin(azimuth), std::sin(zenith) * std::cos(azimuth),
                        std::cos(zenith)};
    };
    const auto left = cartesian(-kStep, 0);
    const auto right = cartesian(kStep, 0);
    const auto top = cartesian(0, -kStep);
    const auto bottom = cartesian(0, kStep);
    std::array<double, 3> a{};
    std::array<double, 3> b{};
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = right[i] - left[i];
      b[i] = bottom[i] - top[i];
    }
    const double area =
        std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    EXPECT_NEAR(area / (4 * kStep * kStep) / picture->density_sr(x, y), 1.0, 1e-4) << name;
  }
}

// Columns mirrored in the north-south line have the same zenith angle and mirrored azimuths.
TEST(Projections, MirroredPixelsHaveMirroredAngles) {
  for (const char* name : {"fisheye", "fisheye-equisolid", "octahedral"}) {
    const auto picture = one(name, 30);
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 15; ++column) {
        const auto left = picture->direction(column, row);
        const auto right = picture->direction(29 - column, row);
        ASSERT_EQ(left.has_value(), right.has_value());
        if (!left) continue;
        EXPECT_EQ(left->zenith_deg, right->zenith_deg);
        EXPECT_NEAR(left->azimuth_deg + right->azimuth_deg, 360.0, 1e-12);
      }
  }
}

// The inverse of direction_at, on exactly one of a cube's faces.
TEST(Projections, DirectionsHaveTheirPoints) {
  for (const std::string& name : projection_names())
    for (const SkyPart part : {SkyPart::sphere, SkyPart::hemisphere}) {
      if (part == SkyPart::hemisphere && !shows_hemispheres(name)) continue;
      const auto pictures = make_projections({name, 16, part});
      for (double zenith_deg = 0.0; zenith_deg <= 180.0; zenith_deg += 7.5)
        for (double azimuth_deg = 0.0; azimuth_deg < 360.0; azimuth_deg += 7.5) {
          int shown = 0;
          for (const auto& picture : pictures) {
            const auto point = picture->point_of({zenith_deg, azimuth_deg});
            if (!point) continue;
            ++shown;
            ASSERT_TRUE(point->x >= 0.0 && point->x <= picture->width()) << name << " " << point->x;
            ASSERT_TRUE(point->y >= 0.0 && point->y <= picture->height()) << name << " " << point->y;
            // A fisheye's rim may lie 1e-16 beyond itself.
            const auto back = picture->direction_at(point->x, point->y);
            if (back) expect_direction(*picture, point->x, point->y, {zenith_deg, azimuth_deg});
            EXPECT_TRUE(back || zenith_deg == 90.0 || zenith_deg == 180.0) << name << " " << zenith_deg;
          }
          const bool hidden = part == SkyPart::hemisphere && zenith_deg > 90.0;
          EXPECT_EQ(shown, hidden ? 0 : 1) << name << " " << zenith_deg << " " << azimuth_deg;
        }
    }
}

// Along the seams of a cross, too, the pixel that holds a point is one that has directions.
TEST(Projections, PointsOfACrossLieInItsPixels) {
  const auto cross = one("cube-cross", 7);
  for (double zenith_deg = 0.0; zenith_deg <= 180.0; zenith_deg += 1.25)
    for (double azimuth_deg = 0.0; azimuth_deg < 360.0; azimuth_deg += 2.5) {
      const auto point = cross->point_of({zenith_deg, azimuth_deg});
      ASSERT_TRUE(point);
      EXPECT_GT(cross->solid_angle_sr(static_cast<int>(point->x), static_cast<int>(point->y)), 0.0)
          << zenith_deg << " " << azimuth_deg;
    }
}

TEST(Projections, UnknownNamesSizesAndPartsAreRefused) {
  for (const char* name : {"", "LATLONG", "mercator"})
    EXPECT_THROW(make_projections({name, 16, {}}), InputError) << name;
  for (const int size : {1, 16385}) EXPECT_THROW(make_projections({"latlong", size, {}}), InputError) << size;
  for (const char* name : {"cube", "cube-cross", "octahedral"})
    EXPECT_THROW(make_projections({name, 16, SkyPart::hemisphere}), InputError) << name;
  EXPECT_EQ(make_projections({"latlong", 16384, {}}).front()->width(), 32768);
}

}  // namespace
}  // namespace skylut
