#include "spherical/ray_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"

namespace skylut::transfer {
namespace {

const OpticalColumn& column() {
  static const OpticalColumn one = test::column_of({.rayleigh_depth = 0.2});
  return one;
}

const Discretisation& grid() {
  static const Discretisation one(
      test::earth(), discretisation_for(test::earth(), column(), Quality::standard), Quality::standard);
  return one;
}

/// A ray with the view that the kernel gets of it.
struct Ray {
  Ray(double observer_km, double zenith_deg, std::vector<SunAzimuth> pairs = {{45.0, 30.0}})
      : geometry(grid(), observer_km, zenith_deg, pairs), view(geometry.view(grid())) {}
  double length() const {
    double sum = 0.0;
    for (int i = 0; i < view.segments; ++i) sum += view.segment[i].length_km;
    return sum;
  }
  double height(int segment, bool far) const {
    const RaySegment& part = view.segment[segment];
    const double lower = grid().sublayers.level_km(part.sublayer);
    const double upper = grid().sublayers.level_km(part.sublayer + 1);
    return lower + (far ? part.far_fraction : part.near_fraction) * (upper - lower);
  }
  RayGeometry geometry;
  RayView view;
};

double horizon_deg(double observer_km) {
  return 180.0 - std::asin(6371.0 / (6371.0 + observer_km)) * kDegreesPerRadian;
}

/// Length of the ray from the observer to the ground or to the top at 100 km.
double exact_length(double observer_km, double zenith_deg) {
  const long double r = 6371.0L + observer_km;
  const long double along = r * std::cos(static_cast<long double>(zenith_deg) * std::acos(-1.0L) / 180.0L);
  const long double to_ground = 6371.0L * 6371.0L - r * r + along * along;
  const long double to_top = 6471.0L * 6471.0L - r * r + along * along;
  const bool ground = zenith_deg > horizon_deg(observer_km);
  return static_cast<double>(ground ? -along - std::sqrt(to_ground) : std::sqrt(to_top) - along);
}

// Segments add up to the ray, follow each other in height, and lie within their sublayers.
TEST(RayGeometry, SegmentsAddUpToTheRay) {
  for (const double observer : {0.0, 0.01, 3.0, 12.0, 30.0, 99.0, 100.0})
    for (const double zenith : {0.0, 30.0, 75.0, 89.0, 90.0, 91.0, 93.0, 96.0, 120.0, 180.0}) {
      if (observer == 0.0 && zenith > 90.0) continue;
      const Ray ray(observer, zenith);
      const double expected = exact_length(observer, zenith);
      // Each length rounds to single precision; at 100 km and 90° there is no air ahead. In the tangent
      // direction (r cos)² known to 1e-16 r² leaves 1e-4 km.
      EXPECT_NEAR(ray.length(), expected, 1e-6 * expected + 1e-6) << observer << " " << zenith;
      EXPECT_EQ(ray.view.hits_ground, zenith > horizon_deg(observer)) << observer << " " << zenith;
      for (int i = 0; i + 1 < ray.view.segments; ++i) {
        // Fractions of a sublayer at most 30 km thick, in single precision.
        EXPECT_NEAR(ray.height(i, true), ray.height(i + 1, false), 5e-6)
            << observer << " " << zenith << " " << i;
        EXPECT_LE(ray.view.segment[i].length_km, 1.0001 * grid().limits.ray_step_km);
      }
      if (ray.view.segments == 0) continue;
      EXPECT_NEAR(ray.height(0, false), observer, 5e-6);
      EXPECT_NEAR(ray.height(ray.view.segments - 1, true), ray.view.hits_ground ? 0.0 : 100.0, 5e-6);
    }
}

// A hair (1e-6°: 3.6 milliarcseconds) above the horizon the ray goes on to the other side, below it ends.
TEST(RayGeometry, AHairAboveAndBelowTheHorizon) {
  for (const double observer : {0.001, 1.0, 12.0, 30.0}) {
    const Ray above(observer, horizon_deg(observer) - 1e-6);
    const Ray below(observer, horizon_deg(observer) + 1e-6);
    EXPECT_FALSE(above.view.hits_ground);
    EXPECT_TRUE(below.view.hits_ground);
    const double to_tangent = std::sqrt(observer * (2.0 * 6371.0 + observer));
    const double beyond = std::sqrt(100.0 * (2.0 * 6371.0 + 100.0));
    // Tangent at h = 1e-6° · √(2Rh) ~ 10 mm: the ground is met √(2R · 10 mm) = 0.4 km or less before it.
    EXPECT_NEAR(below.length(), to_tangent, 0.5) << observer;
    EXPECT_NEAR(above.length(), to_tangent + beyond, 0.01) << observer;
  }
  const Ray level(0.0, 90.0);
  EXPECT_FALSE(level.view.hits_ground);
  EXPECT_TRUE(Ray(0.0, 90.0001).view.hits_ground);
}

/// Points of one ray and whether the sun reaches them, by vectors.
struct Shadow {
  Shadow(double observer_km, double zenith_deg, const SunAzimuth& pair)
      : r(6371.0 + observer_km),
        zenith(zenith_deg * kRadiansPerDegree),
        sun(pair.sun_zenith_deg * kRadiansPerDegree),
        azimuth(pair.relative_azimuth_deg * kRadiansPerDegree) {}
  bool lit(double distance) const {
    const double x = distance * std::sin(zenith) * std::cos(azimuth);
    const double y = distance * std::sin(zenith) * std::sin(azimuth);
    const double z = r + distance * std::cos(zenith);
    const double towards = x * std::sin(sun) + z * std::cos(sun);
    return towards >= 0.0 || x * x + y * y + z * z - towards * towards >= 6371.0 * 6371.0;
  }
  /// Boundary between a lit and a dark point.
  double edge(double a, double b) const {
    for (int i = 0; i < 60; ++i) (lit(0.5 * (a + b)) == lit(a) ? a : b) = 0.5 * (a + b);
    return a;
  }
  double lit_length(double length) const {
    double sum = 0.0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
      const double a = length * i / kSteps;
      const double b = length * (i + 1) / kSteps;
      if (lit(a) != lit(b)) {
        sum += lit(a) ? edge(a, b) - a : b - edge(a, b);
      } else if (lit(a)) {
        sum += b - a;
      }
    }
    return sum;
  }
  double r, zenith, sun, azimuth;
};

TEST(RayGeometry, LitPartsEndOnTheShadow) {
  int dark = 0;
  for (const double observer : {0.0, 12.0, 30.0})
    for (const double zenith : {0.0, 60.0, 85.0, 90.0, 93.0, 97.0})
      for (const double sun : {60.0, 89.0, 90.0, 91.0, 93.0, 96.0})
        for (const double azimuth : {0.0, 40.0, 90.0, 180.0}) {
          if (observer == 0.0 && zenith > 90.0) continue;
          const SunAzimuth pair{sun, azimuth};
          const Ray ray(observer, zenith, {pair});
          double lit = 0.0;
          for (int i = 0; i < ray.view.first_lit[1]; ++i) lit += ray.view.lit[i].length_km;
          const double expected = Shadow(observer, zenith, pair).lit_length(ray.length());
          if (expected < 0.999 * ray.length()) ++dark;
          // Single-precision lengths; where the shadow's edge grazes the ray (the sun on the horizon), the
          // squares of radii in the double-precision check above are good to √1e-16 r = 0.1 m only.
          EXPECT_NEAR(lit, expected, 1e-6 * ray.length() + 2e-4)
              << observer << " " << zenith << " " << sun << " " << azimuth;
        }
  EXPECT_GT(dark, 100);  // the cases do cross the shadow
}

// Every lit part: its ends' altitudes and the lowest altitude of the sunbeam through them.
TEST(RayGeometry, LitPartsKnowTheirSunbeam) {
  const SunAzimuth pair{92.0, 60.0};
  const Ray ray(12.0, 88.0, {pair});
  ASSERT_GT(ray.view.first_lit[1], 5);
  for (int i = 0; i < ray.view.first_lit[1]; ++i) {
    const LitPart& part = ray.view.lit[i];
    double start = part.start_km;
    for (int segment = 0; segment < part.segment; ++segment) start += ray.view.segment[segment].length_km;
    const double zenith = 88.0 * kRadiansPerDegree;
    const double sun = 92.0 * kRadiansPerDegree;
    const double x = start * std::sin(zenith) * std::cos(60.0 * kRadiansPerDegree);
    const double y = start * std::sin(zenith) * std::sin(60.0 * kRadiansPerDegree);
    const double z = 6383.0 + start * std::cos(zenith);
    const double towards = x * std::sin(sun) + z * std::cos(sun);
    const double square = x * x + y * y + z * z;
    // Distances of up to 1500 km summed from single-precision lengths: 1e-4 km.
    EXPECT_NEAR(part.near_altitude_km, std::sqrt(square) - 6371.0, 1e-4);
    EXPECT_NEAR(part.near_perigee_km, std::sqrt(square - towards * towards) - 6371.0, 1e-4);
    EXPECT_EQ(part.near_down, towards < 0.0);
    EXPECT_GE(std::max(part.near_perigee_km, part.far_perigee_km), -1e-4);
  }
}

}  // namespace
}  // namespace skylut::transfer
