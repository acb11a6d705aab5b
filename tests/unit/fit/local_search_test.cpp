#include "fit/local_search.hpp"

#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "skylut/core/constants.hpp"
#include "skylut/fit/dome_directions.hpp"

namespace skylut {
namespace {

// A thin hazy layer with a Henyey-Greenstein aureole, as fit_perez_test has it, over the dome's directions.
std::vector<SkySample> hazy_sky(const Direction& sun, double depth, double g) {
  std::vector<SkySample> samples;
  const DomeDirections dome = dome_directions(sun);
  for (std::size_t i = 0; i < dome.directions.size(); ++i) {
    const double zenith = dome.directions[i].zenith_deg * kRadiansPerDegree;
    const double gamma = angle_between(dome.directions[i], sun);
    const double cosine = std::cos(gamma);
    const double phase =
        0.375 * (1.0 + cosine * cosine) + 0.5 * (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
    const double emitted =
        zenith > 89.99 * kRadiansPerDegree ? 1.0 : 1.0 - std::exp(-depth / std::cos(zenith));
    samples.push_back({zenith, gamma, emitted * phase, dome.solid_angles_sr[i]});
  }
  return samples;
}

// The formula as Perez writes it, with derivatives of its own: nothing of the fit's linear form.
struct PerezResidual {
  SkySample sample;
  double sun_zenith_rad, zenith_value, scale;

  template <class T>
  bool operator()(const T* k, T* residual) const {
    const T here = perez(k[0], k[1], k[2], k[3], k[4], std::cos(sample.zenith_rad), sample.gamma_rad,
                         std::cos(sample.gamma_rad));
    const T zenith = perez(k[0], k[1], k[2], k[3], k[4], 1.0, sun_zenith_rad, std::cos(sun_zenith_rad));
    *residual = scale * (zenith_value * here / zenith - sample.value) / sample.value;
    return true;
  }
};

// Where Ceres ends that begins at our minimum.
double cost_by_ceres(const std::vector<SkySample>& samples, double sun_zenith_rad, const FitReport& report,
                     const FitOptions& options) {
  double weights = 0.0;
  for (const SkySample& sample : samples) weights += sample.weight;
  std::array<double, 5> k = report.coefficients.values();
  ceres::Problem problem;
  for (const SkySample& sample : samples)
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PerezResidual, 1, 5>(new PerezResidual{
                                 sample, sun_zenith_rad, report.zenith_value,
                                 std::sqrt(sample.weight * static_cast<double>(samples.size()) / weights)}),
                             nullptr, k.data());
  problem.SetParameterLowerBound(k.data(), 1, options.B_lower);
  problem.SetParameterUpperBound(k.data(), 1, options.B_upper);
  problem.SetParameterLowerBound(k.data(), 3, options.D_lower);
  problem.SetParameterUpperBound(k.data(), 3, options.D_upper);
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.logging_type = ceres::SILENT;
  solver.max_num_iterations = 300;
  solver.function_tolerance = 1e-15;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  return summary.final_cost;
}

TEST(LocalSearch, CeresFindsNothingLowerFromWhereItEnded) {
  for (const double sun_deg : {10.0, 45.0, 85.0, 90.0})
    for (const double g : {0.3, 0.75}) {
      const auto samples = hazy_sky({sun_deg, 0.0}, 0.3, g);
      const FitOptions options;
      const double sun = sun_deg * kRadiansPerDegree;
      const FitReport report = fit_perez(samples, sun, samples[0].value, options);
      EXPECT_EQ(report.termination, Termination::converged) << report.message;
      const double judged = cost_by_ceres(samples, sun, report, options);
      EXPECT_GE(judged, report.cost * (1.0 - 1e-9)) << sun_deg << " " << g;
      EXPECT_LE(judged, report.cost * (1.0 + 1e-9));  // the same function
    }
}

double scattering_at_zenith(const PerezCoefficients& k, double sun) {
  return 1.0 + k.C * std::exp(k.D * sun) + k.E * std::cos(sun) * std::cos(sun);
}

// A bright aureole around a high sun: 1 + C e^{Dθ_s} + E cos²θ_s is 25.7 at the free minimum, and may be 10.
TEST(LocalSearch, HoldsTheFactorsAtTheZenith) {
  const double sun = 5.0 * kRadiansPerDegree;
  const PerezCoefficients k{-0.9, -0.2, 40.0, -6.0, 1.0};
  std::vector<SkySample> samples = hazy_sky({5.0, 0.0}, 0.3, 0.3);
  for (SkySample& sample : samples)
    sample.value = perez_relative(k, sample.zenith_rad, sample.gamma_rad, sun);
  ASSERT_NEAR(scattering_at_zenith(fit_perez(samples, sun, 1.0, {}).coefficients, sun), 25.7, 0.1);
  FitOptions options;
  options.largest_scattering = 10.0;
  const FitReport held = fit_perez(samples, sun, 1.0, options);
  EXPECT_NEAR(scattering_at_zenith(held.coefficients, sun), 10.0, 1e-6);
  EXPECT_EQ(held.termination, Termination::converged) << held.message;
  // Nothing near by with the same factor is lower: C follows from it.
  std::mt19937 random(1);
  std::normal_distribution<double> any(0.0, 0.01);
  for (int i = 0; i < 200; ++i) {
    PerezCoefficients other = held.coefficients;
    other.A *= 1.0 + any(random);
    other.B = std::min(other.B * (1.0 + any(random)), options.B_upper);
    other.D *= 1.0 + any(random);
    other.E *= 1.0 + any(random);
    other.C = (9.0 - other.E * std::cos(sun) * std::cos(sun)) * std::exp(-other.D * sun);
    EXPECT_GE(perez_cost(samples, sun, 1.0, ResidualKind::relative, other), held.cost * (1.0 - 1e-9));
  }
}

TEST(LocalSearch, TheGradationAtTheZenithIsBounded) {
  const double sun = 45.0 * kRadiansPerDegree;
  const PerezCoefficients k{30.0, -0.3, 1.0, -2.0, 0.4};  // 1 + A e^B = 23.2
  std::vector<SkySample> samples = hazy_sky({45.0, 0.0}, 0.3, 0.3);
  for (SkySample& sample : samples)
    sample.value = perez_relative(k, sample.zenith_rad, sample.gamma_rad, sun);
  FitOptions options;
  options.largest_gradation = 8.0;
  const PerezCoefficients held = fit_perez(samples, sun, 1.0, options).coefficients;
  EXPECT_LE(1.0 + held.A * std::exp(held.B), 8.0 * (1.0 + 1e-9));
  EXPECT_NEAR(fit_perez(samples, sun, 1.0, {}).coefficients.A, 30.0, 1e-4);
}

// Two minima of one sky, the deeper first; the other only if it may cost more.
TEST(LocalSearch, MinimaThatAreNearlyAsGood) {
  const auto samples = hazy_sky({0.0, 0.0}, 0.3, 0.75);
  const auto all = perez_minima(samples, 0.0, samples[0].value, {}, 1e3);
  ASSERT_GE(all.size(), 2u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GE(all[i].cost, all[i - 1].cost);
    EXPECT_NE(all[i].coefficients, all[i - 1].coefficients);
  }
  const double between = 0.5 * (all[1].cost / all[0].cost - 1.0);
  EXPECT_EQ(perez_minima(samples, 0.0, samples[0].value, {}, between).size(), 1u);
  EXPECT_EQ(fit_perez(samples, 0.0, samples[0].value, {}).coefficients, all[0].coefficients);
}

}  // namespace
}  // namespace skylut
