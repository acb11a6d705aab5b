#include "spherical/ray_sources.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"

namespace skylut::transfer {
namespace {

/// 0.5 km layers, which the sweep merges; the haze splits the lowest of them.
struct Grids {
  static Shells shells() {
    Shells shells{{0.0}, 6371.0};
    for (int i = 1; i <= 60; ++i) shells.levels_km.push_back(0.5 * i);
    return shells;
  }
  static OpticalColumn haze() {
    OpticalColumn column;
    for (int i = 0; i < 60; ++i) column.extinction_depth.push_back(0.3 * std::exp(-0.25 * i));
    column.scatterers.push_back(
        {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.7), column.extinction_depth});
    return column;
  }
  CommonGrid common{shells(), discretisation_of(Quality::standard)};
  Discretisation grid{common, discretisation_for(common.merge, common.discretisation, haze())};
};

/// A ray under one sun.
struct SourcesOfRay {
  SourcesOfRay(const Grids& grids, double observer_km, double zenith_deg, const SunAzimuth& pair)
      : trace(grids.grid.ray_levels, grids.common.discretisation.ray_step_km, observer_km,
              std::cos(zenith_deg * kRadiansPerDegree)),
        ray(grids.common.ray_space(), observer_km, zenith_deg, std::span(&pair, 1),
            grids.grid.angles.azimuthal_orders()),
        sources(grids.grid, ray, false),
        view(sources.view()) {}
  RayTrace trace;
  Ray ray;
  RaySources sources;
  RaySourcesView view;
};

// Pieces add up to the ray and follow each other between the sources.
TEST(RaySources, PiecesJoinTheSources) {
  const Grids grids;
  ASSERT_LT(grids.common.merge.shells().levels_km.size(), grids.common.shells.levels_km.size());
  for (const double observer : {0.0, 0.3, 12.0, 29.0})
    for (const double zenith : {0.0, 60.0, 90.0, 93.0, 150.0}) {
      if (observer == 0.0 && zenith > 90.0) continue;
      const SourcesOfRay ray(grids, observer, zenith, {45.0, 30.0});
      const RaySourcesView& view = ray.view;
      double length = 0.0;
      for (int i = 0; i < view.pieces; ++i) {
        const SourcePiece& piece = view.piece[i];
        length += piece.length_km;
        EXPECT_LT(piece.near_fraction, piece.far_fraction);
        const bool first = i == 0 || view.piece[i - 1].source != piece.source;
        const bool last = i + 1 == view.pieces || view.piece[i + 1].source != piece.source;
        EXPECT_EQ(piece.near_fraction == 0.0f, first);
        EXPECT_EQ(piece.far_fraction == 1.0f, last);
      }
      EXPECT_EQ(view.piece[view.pieces - 1].source + 2, view.sources);
      EXPECT_NEAR(length, ray.trace.points.back().distance_km, 1e-5 * length) << observer << " " << zenith;
      const auto height = [&](const SourcePoint& source) {
        const double lower = grids.grid.sublayers.level_km(source.sublayer);
        return lower + source.fraction * (grids.grid.sublayers.level_km(source.sublayer + 1) - lower);
      };
      // Fractions of a sublayer at most 5 km thick, in single precision.
      EXPECT_NEAR(height(view.source[0]), observer, 1e-6);
      EXPECT_NEAR(height(view.source[view.sources - 1]), ray.trace.points.back().altitude_km, 1e-6);
    }
}

// From 12 km this line's lowest point lies on the boundary at 2.5 km to the last bit: it is one point of the
// line, not two with a piece of no length between them.
TEST(RaySources, ALineThatTouchesABoundary) {
  const Grids grids;
  const SourcesOfRay ray(grids, 12.0, 93.12637370818095, {60.0, 90.0});
  for (std::size_t i = 0; i + 1 < ray.trace.points.size(); ++i)
    EXPECT_LT(ray.trace.points[i].distance_km, ray.trace.points[i + 1].distance_km) << i;
  for (int i = 0; i < ray.view.pieces; ++i) {
    EXPECT_GT(ray.view.piece[i].length_km, 0.0f) << i;
    EXPECT_TRUE(std::isfinite(ray.view.piece[i].near_fraction)) << i;
    EXPECT_TRUE(std::isfinite(ray.view.piece[i].far_fraction)) << i;
  }
}

// The local sun and azimuth at every source, by vectors: the weights interpolate the zenith angle itself, and
// the factor of order 1 is twice the cosine of the azimuth.
TEST(RaySources, LocalSunAndAzimuth) {
  const Grids grids;
  const SunAzimuth pair{88.0, 70.0};
  const double zenith = 85.0 * kRadiansPerDegree;
  const SourcesOfRay ray(grids, 2.0, 85.0, pair);
  const RaySourcesView& view = ray.view;
  const double sun = pair.sun_zenith_deg * kRadiansPerDegree;
  const double azimuth = pair.relative_azimuth_deg * kRadiansPerDegree;
  const double towards_sun[3] = {std::sin(sun), 0.0, std::cos(sun)};
  const double direction[3] = {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth),
                               std::cos(zenith)};
  double distance = 0.0;
  int piece = 0;
  for (int at = 0; at < view.sources; ++at) {
    double up[3] = {direction[0] * distance, direction[1] * distance, 6373.0 + direction[2] * distance};
    const double r = std::hypot(up[0], up[1], up[2]);
    double cos_sun = 0.0;
    double cos_view = 0.0;
    double cos_between = 0.0;
    for (int i = 0; i < 3; ++i) {
      up[i] /= r;
      cos_sun += up[i] * towards_sun[i];
      cos_view += up[i] * direction[i];
      cos_between += towards_sun[i] * direction[i];
    }
    double angle = 0.0;
    for (int t = 0; t < 4; ++t)
      angle += view.sun_weights[at][0].weight[t] *
               grids.common.sun_nodes_deg[static_cast<std::size_t>(view.sun_weights[at][0].first + t)];
    // Distances summed from single-precision lengths, weights in single precision: 1e-5 of 90°.
    EXPECT_NEAR(angle, std::acos(cos_sun) * kDegreesPerRadian, 1e-4);
    const double cos_azimuth = (cos_between - cos_sun * cos_view) /
                               std::sqrt((1.0 - cos_sun * cos_sun) * (1.0 - cos_view * cos_view));
    const float* factor = view.azimuth_factor[at];
    EXPECT_EQ(factor[0], 1.0f);
    EXPECT_NEAR(factor[1], 2.0 * cos_azimuth, 1e-5);
    EXPECT_NEAR(factor[2], 2.0 * (2.0 * cos_azimuth * cos_azimuth - 1.0), 3e-5);
    for (; piece < view.pieces && view.piece[piece].source == at; ++piece)
      distance += view.piece[piece].length_km;
  }
}

}  // namespace
}  // namespace skylut::transfer
