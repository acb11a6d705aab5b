#include "geometry/ray.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"
#include "spherical/common_grid.hpp"

namespace skylut::transfer {
namespace {

const CommonGrid& common() {
  static const CommonGrid one(test::earth(), discretisation_of(Quality::standard));
  return one;
}

/// A ray with the view that the kernel gets of it.
struct ViewedRay {
  ViewedRay(double observer_km, double zenith_deg, std::vector<SunAzimuth> pairs = {{45.0, 30.0}})
      : trace(common().layers, common().discretisation.ray_step_km, observer_km,
              std::cos(zenith_deg * kRadiansPerDegree)),
        ray(common().ray_space(), observer_km, zenith_deg, pairs, 2),
        view(ray.view()) {}
  double length() const {
    double sum = 0.0;
    for (int i = 0; i < view.segments; ++i) sum += view.segment[i].length_km;
    return sum;
  }
  RayTrace trace;
  Ray ray;
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

// Segments add up to the ray and lie within their layers; points follow the law of cosines.
TEST(Ray, SegmentsAddUpToTheRay) {
  for (const double observer : {0.0, 0.01, 3.0, 12.0, 30.0, 99.0, 100.0})
    for (const double zenith : {0.0, 30.0, 75.0, 89.0, 90.0, 91.0, 93.0, 96.0, 120.0, 180.0}) {
      if (observer == 0.0 && zenith > 90.0) continue;
      const ViewedRay ray(observer, zenith);
      const double expected = exact_length(observer, zenith);
      // Each length rounds to single precision; at 100 km and 90° there is no air ahead. In the tangent
      // direction (r cos)² known to 1e-16 r² leaves 1e-4 km.
      EXPECT_NEAR(ray.length(), expected, 1e-6 * expected + 1e-6) << observer << " " << zenith;
      EXPECT_EQ(ray.view.hits_ground, zenith > horizon_deg(observer)) << observer << " " << zenith;
      ASSERT_EQ(ray.trace.points.size(), static_cast<std::size_t>(ray.view.segments) + 1);
      const double cosine = std::cos(zenith * kRadiansPerDegree);
      for (int i = 0; i < ray.view.segments; ++i) {
        const RaySegment& segment = ray.view.segment[i];
        EXPECT_LE(segment.length_km, 1.0001 * common().discretisation.ray_step_km);
        for (const RayPoint& end : {ray.trace.points[static_cast<std::size_t>(i)],
                                    ray.trace.points[static_cast<std::size_t>(i) + 1]}) {
          const double r = 6371.0 + observer;
          const double d = end.distance_km;
          // Squares of radii in double precision: 1e-16 r² / r.
          EXPECT_NEAR(end.altitude_km, std::sqrt(r * r + d * d + 2.0 * d * r * cosine) - 6371.0, 1e-9);
          EXPECT_GE(end.altitude_km, common().layers.level_km(segment.layer) - 1e-9);
          EXPECT_LE(end.altitude_km, common().layers.level_km(segment.layer + 1) + 1e-9);
        }
      }
    }
}

// A hair (1e-6°: 3.6 milliarcseconds) above the horizon the ray goes on to the other side, below it ends.
TEST(Ray, AHairAboveAndBelowTheHorizon) {
  for (const double observer : {0.001, 1.0, 12.0, 30.0}) {
    const ViewedRay above(observer, horizon_deg(observer) - 1e-6);
    const ViewedRay below(observer, horizon_deg(observer) + 1e-6);
    EXPECT_FALSE(above.view.hits_ground);
    EXPECT_TRUE(below.view.hits_ground);
    const double to_tangent = std::sqrt(observer * (2.0 * 6371.0 + observer));
    const double beyond = std::sqrt(100.0 * (2.0 * 6371.0 + 100.0));
    // Tangent at h = 1e-6° · √(2Rh) ~ 10 mm: the ground is met √(2R · 10 mm) = 0.4 km or less before it.
    EXPECT_NEAR(below.length(), to_tangent, 0.5) << observer;
    EXPECT_NEAR(above.length(), to_tangent + beyond, 0.01) << observer;
  }
  const ViewedRay level(0.0, 90.0);
  EXPECT_FALSE(level.view.hits_ground);
  EXPECT_TRUE(ViewedRay(0.0, 90.0001).view.hits_ground);
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

TEST(Ray, LitPartsEndOnTheShadow) {
  int dark = 0;
  for (const double observer : {0.0, 12.0, 30.0})
    for (const double zenith : {0.0, 60.0, 85.0, 90.0, 93.0, 97.0})
      for (const double sun : {60.0, 89.0, 90.0, 91.0, 93.0, 96.0})
        for (const double azimuth : {0.0, 40.0, 90.0, 180.0}) {
          if (observer == 0.0 && zenith > 90.0) continue;
          const SunAzimuth pair{sun, azimuth};
          const ViewedRay ray(observer, zenith, {pair});
          double lit = 0.0;
          for (int i = 0; i < ray.view.first_lit[ray.view.segments]; ++i) lit += ray.view.lit[i].length_km;
          const double expected = Shadow(observer, zenith, pair).lit_length(ray.length());
          if (expected < 0.999 * ray.length()) ++dark;
          // Single-precision lengths; where the shadow's edge grazes the ray (the sun on the horizon), the
          // squares of radii in the double-precision check above are good to √1e-16 r = 0.1 m only.
          EXPECT_NEAR(lit, expected, 1e-6 * ray.length() + 2e-4)
              << observer << " " << zenith << " " << sun << " " << azimuth;
        }
  EXPECT_GT(dark, 100);  // the cases do cross the shadow
}

}  // namespace
}  // namespace skylut::transfer
