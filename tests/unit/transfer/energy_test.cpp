#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

const std::vector<double> kSuns_deg = {0.0, 45.0, 75.0};

using Columns = std::vector<OpticalColumn>;
using Fluxes = std::vector<std::vector<double>>;

/// Irradiances from radiances, on a planet so large that the air is plane.
class Irradiance {
 public:
  /// Polar angles crowd the horizon as μ = t²; azimuths are midpoints, which integrate cos mφ, m < 16.
  Irradiance() {
    const Quadrature rule = gauss_legendre(16, 0.0, 1.0);
    for (std::size_t i = 0; i < rule.node.size(); ++i)
      for (int k = 0; k < kAzimuths; ++k) {
        const double mu = rule.node[i] * rule.node[i];
        const double azimuth = (k + 0.5) * 180.0 / kAzimuths;
        upper_.push_back({std::acos(mu) * kDegreesPerRadian, azimuth});
        lower_.push_back({180.0 - std::acos(mu) * kDegreesPerRadian, azimuth});
        weight_.push_back(2.0 * kPi / kAzimuths * 2.0 * rule.node[i] * rule.weight[i] * mu);
      }
  }
  /// Upward diffuse irradiance at the top, per column and sun.
  Fluxes reflected(const Columns& columns) const { return at(columns, 100.0, lower_); }
  /// Downward diffuse irradiance of the ground.
  Fluxes ground_diffuse(const Columns& columns) const { return at(columns, 0.0, upper_); }

 private:
  static constexpr int kAzimuths = 16;
  Fluxes at(const Columns& columns, double altitude_km, const std::vector<RelativeView>& views) const {
    const SkyRadiance sky = test::solve(test::huge_planet(), columns, {{altitude_km}, kSuns_deg, views});
    Fluxes flux(columns.size(), std::vector<double>(kSuns_deg.size()));
    for (std::size_t column = 0; column < columns.size(); ++column)
      for (std::size_t sun = 0; sun < kSuns_deg.size(); ++sun)
        for (std::size_t view = 0; view < views.size(); ++view)
          flux[column][sun] += weight_[view] * static_cast<double>(sky.at(column, 0, sun, view));
    return flux;
  }
  std::vector<RelativeView> upper_, lower_;
  std::vector<double> weight_;
};

const test::Air kConservativeAirs[] = {
    {.rayleigh_depth = 0.1},
    {.rayleigh_depth = 0.5},
    {.haze_depth = 0.3, .haze_asymmetry = 0.7},
    {.rayleigh_depth = 0.2, .haze_depth = 1.0, .haze_asymmetry = 0.75},
    {.rayleigh_depth = 0.1, .haze_depth = 2.0, .haze_asymmetry = 0.6},
};

double total_depth(const OpticalColumn& column) {
  double sum = 0.0;
  for (const double depth : column.extinction_depth) sum += depth;
  return sum;
}

// Issue's bar: conservative scattering conserves flux to 1e-3 of the incident light.
constexpr double kFluxError = 1e-3;

// No absorption above a ground of albedo A: what falls on the top comes back or warms the ground,
// μ0 = F_up(top) + (1-A) (F_diffuse + μ0 e^{-τ/μ0}).
TEST(Energy, WhatIsNotAbsorbedComesBack) {
  Columns columns;
  for (test::Air air : kConservativeAirs)
    for (const double albedo : {0.0, 0.3, 1.0}) {
      air.ground_albedo = albedo;
      columns.push_back(test::column_of(air));
    }
  const Irradiance irradiance;
  const Fluxes reflected = irradiance.reflected(columns);
  const Fluxes diffuse = irradiance.ground_diffuse(columns);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (std::size_t sun = 0; sun < kSuns_deg.size(); ++sun) {
      const double mu0 = std::cos(kSuns_deg[sun] * kRadiansPerDegree);
      const double direct = mu0 * std::exp(-total_depth(columns[c]) / mu0);
      const double absorbed = (1.0 - columns[c].ground_albedo) * (diffuse[c][sun] + direct);
      EXPECT_NEAR((reflected[c][sun] + absorbed) / mu0, 1.0, kFluxError)
          << "depths " << kConservativeAirs[c / 3].rayleigh_depth << " + "
          << kConservativeAirs[c / 3].haze_depth << ", albedo " << columns[c].ground_albedo << ", sun "
          << kSuns_deg[sun];
    }
}

// The solver's own irradiance, which the ground reflects, equals the integral of the radiances it answers:
// over a grey ground the nadir view is A/π (F_diffuse + F_direct) e^-0 at the ground itself.
TEST(Energy, TheGroundReflectsWhatTheSkySends) {
  const Irradiance irradiance;
  const OpticalColumn column = test::column_of({.rayleigh_depth = 0.2,
                                                .haze_depth = 0.5,
                                                .haze_scattering_albedo = 0.9,
                                                .absorption_depth = 0.1,
                                                .ground_albedo = 0.4});
  const Fluxes diffuse = irradiance.ground_diffuse({column});
  const SkyRadiance nadir = test::solve(test::huge_planet(), column, {{0.0}, kSuns_deg, {{180.0, 0.0}}});
  for (std::size_t sun = 0; sun < kSuns_deg.size(); ++sun) {
    const double mu0 = std::cos(kSuns_deg[sun] * kRadiansPerDegree);
    const double direct = mu0 * std::exp(-total_depth(column) / mu0);
    EXPECT_NEAR(nadir.at(0, 0, sun, 0) / (0.4 / kPi * (diffuse[0][sun] + direct)), 1.0, kFluxError)
        << kSuns_deg[sun];
  }
}

}  // namespace
}  // namespace skylut
