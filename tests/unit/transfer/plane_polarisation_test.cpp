#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/transfer/plane_parallel.hpp"

namespace skylut {
namespace {

using Phase = std::shared_ptr<const PhaseFunction>;

/// Henyey and Greenstein's phase function, polarising as dipoles do: F12/F11 and F33/F11 of Rayleigh.
class PolarisingHaze final : public PhaseFunction {
 public:
  explicit PolarisingHaze(double asymmetry) : shape_(asymmetry) {}
  double value(double mu) const override { return shape_.value(mu); }
  double moment(int l) const override { return shape_.moment(l); }
  ScatteringMatrix matrix(double mu) const override {
    const double f11 = value(mu);
    const double square = mu * mu;
    return {f11, -f11 * (1.0 - square) / (1.0 + square), f11, f11 * 2.0 * mu / (1.0 + square)};
  }

 private:
  HenyeyGreensteinPhaseFunction shape_;
};

OpticalColumn slab(double depth, double albedo, Phase phase, double ground_albedo = 0.0,
                   std::size_t slices = 1) {
  const auto count = static_cast<double>(slices);
  return {std::vector<double>(slices, depth / count),
          {{std::move(phase), std::vector<double>(slices, albedo * depth / count)}},
          ground_albedo};
}

PlaneParallelRequest request(double cos_sun, std::vector<double> depths) {
  PlaneParallelRequest asked;
  asked.cos_sun_zenith = cos_sun;
  asked.output_depths = std::move(depths);
  asked.directions =
      PlaneParallelRequest::every({-1.0, -0.83, -0.31, 0.02, 0.47, 1.0}, {0.0, 1.1, -2.0, kPi});
  asked.polarised = true;
  return asked;
}

// Natraj, Li & Yung 2009 (doi:10.1088/0004-637X/691/2/1909), their tables for depth 0.5, cosine of the sun
// 0.2, black ground: I, Q, U at the bottom for azimuth 90° (irradiance π, eight decimals).
TEST(PlanePolarisation, RayleighAsPublished) {
  PlaneParallelRequest asked;
  asked.cos_sun_zenith = 0.2;
  asked.output_depths = {0.5};
  asked.directions = {{-0.1, kPi / 2.0}, {-0.84, kPi / 2.0}, {-1.0, 0.0}};
  asked.polarised = true;
  const PlaneParallelResult result =
      solve_plane_parallel(slab(0.5, 1.0, std::make_shared<const RayleighPhaseFunction>()), asked);
  EXPECT_NEAR(result.radiance[0], 0.028014911449, 1e-8);
  EXPECT_NEAR(result.stokes_q[0], 0.018774076242, 1e-8);
  EXPECT_NEAR(result.stokes_u[0], 0.006611917040, 1e-8);
  EXPECT_NEAR(result.stokes_u[1], 0.002830382860, 1e-8);
  EXPECT_NEAR(result.radiance[2], 0.014903915040, 1e-8);
  EXPECT_NEAR(result.stokes_q[2], -0.010267814308, 1e-8);
}

// Where scattering makes no polarisation, the radiance is that of the scalar solver.
TEST(PlanePolarisation, WithoutAPolarisingMatrixIsScalar) {
  const OpticalColumn column =
      slab(2.0, 0.97, std::make_shared<const HenyeyGreensteinPhaseFunction>(0.8), 0.3, 2);
  PlaneParallelRequest asked = request(0.4, {0.0, 0.7, 2.0});
  const PlaneParallelResult vector = solve_plane_parallel(column, asked);
  asked.polarised = false;
  const PlaneParallelResult scalar = solve_plane_parallel(column, asked);
  EXPECT_TRUE(scalar.stokes_q.empty());
  for (std::size_t i = 0; i < scalar.radiance.size(); ++i) {
    EXPECT_NEAR(vector.radiance[i], scalar.radiance[i], 1e-10 * scalar.radiance[i]) << i;
    EXPECT_NEAR(vector.stokes_q[i], 0.0, 1e-13);
    EXPECT_NEAR(vector.stokes_u[i], 0.0, 1e-13);
  }
  EXPECT_NEAR(vector.flux_up[0], scalar.flux_up[0], 1e-12);
}

// What the scalar solver gets wrong of I took polarisation to make and polarisation to use: Δ² of Rayleigh's
// matrix.
TEST(PlanePolarisation, ScalarErrorGoesWithTheSquareOfThePolarisation) {
  const auto scalar_error = [](double depolarisation) {
    const OpticalColumn column =
        slab(0.5, 1.0, std::make_shared<const RayleighPhaseFunction>(depolarisation));
    PlaneParallelRequest asked = request(0.8, {0.5});
    asked.directions = {{-1.0, 0.0}};
    const double vector = solve_plane_parallel(column, asked).radiance[0];
    asked.polarised = false;
    return solve_plane_parallel(column, asked).radiance[0] / vector - 1.0;
  };
  const double none = scalar_error(0.0);
  const double half = scalar_error(0.5);  // Δ = 0.5 / 1.25
  EXPECT_GT(std::abs(none), 0.01);
  EXPECT_NEAR(half / none, 0.16, 0.04);
}

TEST(PlanePolarisation, ConservesEnergy) {
  for (double depth : {0.01, 1.0, 32.0})
    for (double ground : {0.0, 1.0}) {
      PlaneParallelRequest asked = request(0.5, {0.0, 0.3 * depth, depth});
      const PlaneParallelResult result =
          solve_plane_parallel(slab(depth, 1.0, std::make_shared<PolarisingHaze>(0.7), ground), asked);
      const double at_top = result.flux_direct[0] + result.flux_down_diffuse[0] - result.flux_up[0];
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(result.flux_direct[i] + result.flux_down_diffuse[i] - result.flux_up[i],
                    ground == 1.0 ? 0.0 : at_top, 1e-10)
            << depth;
    }
}

// I of unpolarised light is reciprocal: I(μ, μ0, φ)/μ0 is symmetric in μ and μ0 (Hovenier 1969).
TEST(PlanePolarisation, ReflectionIsReciprocal) {
  const OpticalColumn column = slab(2.0, 0.95, std::make_shared<PolarisingHaze>(0.7), 0.3);
  const auto reflected = [&](double cos_sun, double cos_view) {
    PlaneParallelRequest asked = request(cos_sun, {0.0});
    asked.directions = {{cos_view, 1.1}};
    return solve_plane_parallel(column, asked).radiance[0] / cos_sun;
  };
  EXPECT_NEAR(reflected(0.35, 0.8) / reflected(0.8, 0.35), 1.0, 1e-7);
}

TEST(PlanePolarisation, SplittingALayerChangesNothing) {
  const PlaneParallelRequest asked = request(0.4, {0.0, 3.0, 10.0});
  const Phase haze = std::make_shared<PolarisingHaze>(0.7);
  const PlaneParallelResult whole = solve_plane_parallel(slab(10.0, 1.0, haze, 0.2), asked);
  const PlaneParallelResult split = solve_plane_parallel(slab(10.0, 1.0, haze, 0.2, 5), asked);
  for (std::size_t i = 0; i < whole.radiance.size(); ++i) {
    EXPECT_NEAR(split.radiance[i], whole.radiance[i], 1e-9 * whole.radiance[i]);
    EXPECT_NEAR(split.stokes_q[i], whole.stokes_q[i], 1e-9 * whole.radiance[i]);
    EXPECT_NEAR(split.stokes_u[i], whole.stokes_u[i], 1e-9 * whole.radiance[i]);
  }
}

// The other side of the sun: I and Q the same, U with the other sign; straight up, Q and U turn with the
// plane.
TEST(PlanePolarisation, HasTheSymmetriesOfTheSun) {
  PlaneParallelRequest asked = request(0.4, {0.3});
  asked.directions = {{-0.6, 0.7}, {-0.6, -0.7}, {-1.0, 0.0}, {-1.0, 0.5}};
  const PlaneParallelResult result =
      solve_plane_parallel(slab(1.0, 1.0, std::make_shared<PolarisingHaze>(0.5), 0.2), asked);
  EXPECT_NEAR(result.radiance[0], result.radiance[1], 1e-15);
  EXPECT_NEAR(result.stokes_q[0], result.stokes_q[1], 1e-15);
  EXPECT_NEAR(result.stokes_u[0], -result.stokes_u[1], 1e-15);
  EXPECT_NEAR(result.stokes_u[2], 0.0, 1e-15);
  EXPECT_NEAR(result.stokes_q[3], result.stokes_q[2] * std::cos(1.0), 1e-9);
  EXPECT_NEAR(std::abs(result.stokes_u[3]), std::abs(result.stokes_q[2] * std::sin(1.0)), 1e-9);
}

// ---- light scattered twice, by plain integration over directions with rotations between planes

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Frame {
  Frame(double mu, double phi)
      : direction{std::sqrt(1.0 - mu * mu) * std::cos(phi), std::sqrt(1.0 - mu * mu) * std::sin(phi), mu},
        theta{mu * std::cos(phi), mu * std::sin(phi), -std::sqrt(1.0 - mu * mu)},
        phi_{-std::sin(phi), std::cos(phi), 0.0} {}
  Vector direction;
  Vector theta;
  Vector phi_;
};

/// Stokes (I, Q, U) turned from a frame into the plane that also holds `other`; or, with sign -1, back.
Vector turned(const Vector& stokes, const Frame& frame, const Vector& other, double sign) {
  const double angle = std::atan2(dot(other, frame.phi_), dot(other, frame.theta));
  const double c = std::cos(2.0 * angle);
  const double s = sign * std::sin(2.0 * angle);
  return {stokes[0], c * stokes[1] + s * stokes[2], c * stokes[2] - s * stokes[1]};
}

Vector scattered(const PhaseFunction& phase, const Vector& stokes, const Frame& from, const Frame& to) {
  const ScatteringMatrix f = phase.matrix(std::clamp(dot(from.direction, to.direction), -1.0, 1.0));
  const Vector in = turned(stokes, from, to.direction, 1.0);
  const Vector out{f.f11 * in[0] + f.f12 * in[1], f.f12 * in[0] + f.f22 * in[1], f.f33 * in[2]};
  return turned(out, to, from.direction, -1.0);
}

/// Downwards from a slab without ground, per squared albedo.
Vector twice_scattered(const PhaseFunction& phase, double depth, double cos_sun, const Frame& view) {
  const Frame beam(-cos_sun, 0.0);
  const double mu = -view.direction[2];
  const Quadrature cosines = gauss_legendre(32, 0.0, 1.0);
  const Quadrature depths = gauss_legendre(12, 0.0, depth);
  constexpr int kAzimuths = 48;
  Vector sum{};
  for (std::size_t i = 0; i < 2 * cosines.node.size(); ++i) {
    const bool up = i % 2 == 0;
    const double cosine = cosines.node[i / 2];
    // Of unit singly scattered sources e^{-t/μ0}: light at depth t, then on its way out.
    double path = 0.0;
    for (std::size_t k = 0; k < depths.node.size(); ++k) {
      const double t = depths.node[k];
      const double light = up ? (std::exp(-t / cos_sun) - std::exp(-depth / cos_sun - (depth - t) / cosine)) /
                                    (1.0 + cosine / cos_sun)
                              : (std::exp(-t / cos_sun) - std::exp(-t / cosine)) / (1.0 - cosine / cos_sun);
      path += depths.weight[k] * light * std::exp(-(depth - t) / mu) / mu;
    }
    for (int j = 0; j < kAzimuths; ++j) {
      const Frame between(up ? cosine : -cosine, 2.0 * kPi * (j + 0.5) / kAzimuths);
      const Vector once = scattered(phase, {1.0, 0.0, 0.0}, beam, between);
      const Vector twice = scattered(phase, once, between, view);
      const double weight = cosines.weight[i / 2] * 2.0 * kPi / kAzimuths * path / std::pow(4.0 * kPi, 2);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * twice[k];
    }
  }
  return sum;
}

TEST(PlanePolarisation, SecondOrderIsThatOfPlainIntegration) {
  const auto haze = std::make_shared<PolarisingHaze>(0.6);
  PlaneParallelRequest asked = request(0.7, {0.4});
  asked.directions = {{-0.5, 0.9}, {-0.9, 2.2}, {-0.25, -1.5}};
  // The orders are told apart by the albedo.
  const auto solved = [&](double albedo) { return solve_plane_parallel(slab(0.4, albedo, haze), asked); };
  const double albedo = 1e-3;
  const PlaneParallelResult one = solved(albedo);
  const PlaneParallelResult two = solved(2.0 * albedo);
  const PlaneParallelResult four = solved(4.0 * albedo);
  for (std::size_t i = 0; i < asked.directions.size(); ++i) {
    const auto second = [&](const std::vector<double>& a, const std::vector<double>& b,
                            const std::vector<double>& c) {
      const double lower = (b[i] - 2.0 * a[i]) / (2.0 * albedo * albedo);  // s2 + 3 ω s3
      const double upper = (c[i] - 2.0 * b[i]) / (8.0 * albedo * albedo);  // s2 + 6 ω s3
      return 2.0 * lower - upper;
    };
    const PlaneDirection& towards = asked.directions[i];
    const Vector expected =
        twice_scattered(*haze, 0.4, 0.7, Frame(towards.cos_view, towards.relative_azimuth_rad));
    EXPECT_NEAR(second(one.radiance, two.radiance, four.radiance), expected[0], 1e-4 * expected[0]);
    EXPECT_NEAR(second(one.stokes_q, two.stokes_q, four.stokes_q), expected[1], 1e-4 * expected[0]);
    EXPECT_NEAR(second(one.stokes_u, two.stokes_u, four.stokes_u), expected[2], 1e-4 * expected[0]);
  }
}

}  // namespace
}  // namespace skylut
