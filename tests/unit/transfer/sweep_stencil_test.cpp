#include "spherical/sweep_stencil.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {
namespace {

const std::vector<double> kLevels_km = {0.0, 0.02, 0.06, 0.5, 1.0, 4.0, 20.0, 100.0};
const std::vector<double> kSunNodes_deg = {0, 10, 20, 30, 40, 50, 60, 70, 80, 84, 88, 90, 92, 96, 100, 104};
const AngularGrid kAngles({8, 6, 10, 8});

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Value interpolated of a function that is linear between them.
template <class T>
double interpolated(const T& weights, const std::vector<double>& node) {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += weights.weight[i] * node[static_cast<std::size_t>(weights.first + i)];
  return sum;
}

double signed_mu(Hemisphere hemisphere, int j) {
  const double alpha = kAngles.cos_polar()[static_cast<std::size_t>(j)];
  return hemisphere == kUp ? alpha : -alpha;
}

/// Calls check(hemisphere, layer, j, end, start): the point at the vertical where the ray of node j leaves
/// the layer, in long double so that the radii keep their digits; and the one where the stencil says it
/// entered.
template <class Check>
void for_each_ray(const ShellGeometry& shells, const SweepStencil& stencil, const Check& check) {
  for (const Hemisphere hemisphere : {kDown, kUp})
    for (int layer = 0; layer < shells.layers(); ++layer)
      for (int j = 0; j < kAngles.polar_nodes(); ++j) {
        const long double mu = signed_mu(hemisphere, j);
        const long double planet = shells.planet_radius_km();
        const long double end = planet + shells.level_km(hemisphere == kDown ? layer : layer + 1);
        const long double length = stencil.polar(hemisphere, layer, j).length_km;
        const long double across = length * std::sqrt(1.0L - mu * mu);
        const long double up = end - length * mu;
        check(hemisphere, layer, j, std::sqrt(up * up + across * across),
              (mu * end - length) / std::sqrt(up * up + across * across));
      }
}

class SweepStencilOfPlanet : public testing::TestWithParam<double> {
 protected:
  ShellGeometry shells{kLevels_km, GetParam()};
  SweepStencil stencil{shells, kAngles, kSunNodes_deg};
};

// Going back along the straight ray by the stencil's length ends on the other boundary of the layer, or, for
// a chord, on the same.
TEST_P(SweepStencilOfPlanet, LengthsReachTheBoundary) {
  for_each_ray(
      shells, stencil, [&](Hemisphere hemisphere, int layer, int j, long double radius, long double) {
        const PolarStep& step = stencil.polar(hemisphere, layer, j);
        const double start_km = shells.level_km(hemisphere == kDown || step.chord ? layer + 1 : layer);
        // The length is single precision: 6e-8 of it, seen at the cosine of the direction (below 1).
        EXPECT_NEAR(static_cast<double>(radius - shells.planet_radius_km()), start_km,
                    1.2e-7 * step.length_km)
            << hemisphere << " " << layer << " " << j;
      });
}

// The polar nodes stand where the ray has its direction at the start: cubic interpolation returns √|μ|
// itself.
TEST_P(SweepStencilOfPlanet, PolarTapsFollowTheDirection) {
  std::vector<double> root;
  for (const double alpha : kAngles.cos_polar()) root.push_back(std::sqrt(alpha));
  for_each_ray(shells, stencil,
               [&](Hemisphere hemisphere, int layer, int j, long double, long double cosine) {
                 const PolarStep& step = stencil.polar(hemisphere, layer, j);
                 if (step.chord) {
                   // A chord meets its boundary at the same angle, going down.
                   EXPECT_NEAR(static_cast<double>(cosine), -signed_mu(hemisphere, j), 1e-6);
                   return;
                 }
                 EXPECT_EQ(hemisphere == kUp, cosine > 0.0L);
                 const double expected =
                     std::clamp(std::sqrt(std::abs(static_cast<double>(cosine))), root.front(), root.back());
                 // Weights and length are single precision; √|μ| at the horizon amplifies by 1/(2 root), at
                 // most 40.
                 EXPECT_NEAR(interpolated(step.upwind, root), expected, 1e-5)
                     << hemisphere << " " << layer << " " << j;
               });
}

// Solar zenith angle at the start, by vectors: the sun stands at (sin θs, 0, cos θs), the beam's azimuth is
// -x, and the light of azimuth φ travels along (-sin θ cos φ, -sin θ sin φ, μ).
TEST_P(SweepStencilOfPlanet, SunTapsFollowTheLocalVertical) {
  for (const Hemisphere hemisphere : {kDown, kUp})
    for (int layer = 0; layer < shells.layers(); ++layer)
      for (int node = 0; node < static_cast<int>(kSunNodes_deg.size()); ++node)
        for (int j = 0; j < kAngles.polar_nodes(); ++j)
          for (int k = 0; k < kAngles.azimuth_nodes(); ++k) {
            const double sun = kSunNodes_deg[static_cast<std::size_t>(node)] * kRadiansPerDegree;
            const double phi = kAngles.azimuth_rad()[static_cast<std::size_t>(k)];
            const double mu = signed_mu(hemisphere, j);
            const double sine = std::sqrt(1.0 - mu * mu);
            const double length = stencil.polar(hemisphere, layer, j).length_km;
            const Vector point = {
                length * sine * std::cos(phi), length * sine * std::sin(phi),
                GetParam() + shells.level_km(hemisphere == kDown ? layer : layer + 1) - length * mu};
            const double cosine =
                dot(point, {std::sin(sun), 0.0, std::cos(sun)}) / std::sqrt(dot(point, point));
            const double expected =
                std::clamp(std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegreesPerRadian, 0.0, 104.0);
            const InterpolationWeights& weights =
                stencil.sun(hemisphere, layer, node)[j * kAngles.azimuth_nodes() + k];
            // Single-precision weights times angles of 100°; near the zenith acos loses hemisphere the
            // digits.
            EXPECT_NEAR(interpolated(weights, kSunNodes_deg), expected, 1e-4)
                << hemisphere << " " << layer << " " << j;
          }
}

// Chords are the rays that leave upwards and whose lowest point lies above the layer's lower boundary.
TEST_P(SweepStencilOfPlanet, ChordsStayAboveTheLowerBoundary) {
  int most = 0;
  for (int layer = 0; layer < shells.layers(); ++layer)
    for (int j = 0; j < kAngles.polar_nodes(); ++j) {
      const long double alpha = signed_mu(kUp, j);
      const long double lowest = (static_cast<long double>(GetParam()) + shells.level_km(layer + 1)) *
                                 std::sqrt(1.0L - alpha * alpha);
      const bool chord = lowest >= static_cast<long double>(GetParam()) + shells.level_km(layer);
      EXPECT_EQ(stencil.polar(kUp, layer, j).chord, chord) << layer << " " << j;
      EXPECT_FALSE(stencil.polar(kDown, layer, j).chord);
      if (chord) most = std::max(most, j + 1);
    }
  EXPECT_EQ(stencil.chord_nodes(), most);
}

INSTANTIATE_TEST_SUITE_P(Planets, SweepStencilOfPlanet, testing::Values(100.0, 6371.0, 6.4e7));

// The limit of planes: lengths Δh/|μ|, directions kept, suns kept.
TEST(SweepStencil, PlanesAreTheLimit) {
  const double planet_km = 1e13;
  const ShellGeometry shells(kLevels_km, planet_km);
  const SweepStencil stencil(shells, kAngles, kSunNodes_deg);
  EXPECT_EQ(stencil.chord_nodes(), 0);
  for (const Hemisphere hemisphere : {kDown, kUp})
    for (int layer = 0; layer < shells.layers(); ++layer)
      for (int j = 0; j < kAngles.polar_nodes(); ++j) {
        const double alpha = kAngles.cos_polar()[static_cast<std::size_t>(j)];
        const double expected = (shells.level_km(layer + 1) - shells.level_km(layer)) / alpha;
        // Δh/(2 R μ²), 2e-4 for 80 km at the lowest node (1.7e-4), and single precision.
        EXPECT_NEAR(stencil.polar(hemisphere, layer, j).length_km / expected, 1.0,
                    80.0 / (planet_km * alpha * alpha) + 1e-7);
        EXPECT_NEAR(
            interpolated(stencil.sun(hemisphere, layer, 8)[j * kAngles.azimuth_nodes()], kSunNodes_deg), 80.0,
            1e-5);
      }
}

}  // namespace
}  // namespace skylut::transfer
