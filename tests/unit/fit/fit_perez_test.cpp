#include "skylut/fit/fit_perez.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/preetham_coefficients.hpp"

namespace skylut {
namespace {

// A sky over the 271 directions; value(θ, γ).
template <class Value>
std::vector<SkySample> sky_of(const Direction& sun, Value value) {
  std::vector<SkySample> samples;
  for (const Direction& view : directions_utm271()) {
    const double zenith = view.zenith_deg * kRadiansPerDegree;
    const double gamma = angle_between(view, sun);
    samples.push_back({zenith, gamma, value(zenith, gamma), 1.0});
  }
  return samples;
}

std::vector<SkySample> perez_sky_of(const Direction& sun, const PerezCoefficients& k, double zenith_value) {
  return sky_of(sun, [&](double zenith, double gamma) {
    return zenith_value * perez_relative(k, zenith, gamma, sun.zenith_deg * kRadiansPerDegree);
  });
}

// A thin hazy layer: (1 - e^{-0.3/cosθ}) times equal parts of a Rayleigh and a Henyey-Greenstein (g = 0.75)
// phase function. No Perez formula fits it exactly, and it has an aureole.
double hazy_layer(double zenith, double gamma) {
  constexpr double g = 0.75;
  const double cos_gamma = std::cos(gamma);
  const double phase = 0.375 * (1.0 + cos_gamma * cos_gamma) +
                       0.5 * (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cos_gamma, 1.5);
  const double emitted = zenith > 89.9 * kRadiansPerDegree ? 1.0 : 1.0 - std::exp(-0.3 / std::cos(zenith));
  return emitted * phase;
}

void expect_coefficients(const PerezCoefficients& found, const PerezCoefficients& expected,
                         double tolerance) {
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(found.values()[i], expected.values()[i],
                tolerance * std::max(1.0, std::abs(expected.values()[i])))
        << kPerezNames[i];
}

TEST(FitPerez, ReturnsTheCoefficientsOfItsOwnSkies) {
  const PerezCoefficients skies[] = {{-0.99, -0.3, 33.7, -4.3, 0.55}, {-1.0, -0.55, 10.0, -3.0, 0.45},
                                     {2.0, -0.8, 1.5, -1.2, 0.1},     {-0.2, -0.05, 0.2, -2.0, -0.05},
                                     {4.0, -0.7, 0.0005, 1.5, 0.3},   preetham1999_coefficients(2.5).Y};
  for (const PerezCoefficients& k : skies)
    for (const double sun_zenith : {20.0, 45.0, 80.0, 90.0, 95.0})
      for (const ResidualKind residual : {ResidualKind::relative, ResidualKind::absolute}) {
        FitOptions options;
        options.residual = residual;
        const auto samples = perez_sky_of({sun_zenith, 90.0}, k, 3.0);
        const FitReport report = fit_perez(samples, sun_zenith * kRadiansPerDegree, 3.0, options);
        // The residuals vanish to rounding, 1e-15; the worst conditioned of these skies multiplies it by 1e8.
        expect_coefficients(report.coefficients, k, 1e-6);
        EXPECT_LT(report.rmse, 1e-10);
        EXPECT_EQ(report.termination, Termination::converged);
        for (const bool determined : report.determined) EXPECT_TRUE(determined) << sun_zenith;
      }
}

// References: the lowest cost that SciPy 1.10 found, by differential evolution over A…E in two boxes and by
// 12 random starts, each polished by its trust-region least squares; to 8 digits.
TEST(FitPerez, FindsTheGlobalMinimum) {
  struct Reference {
    double sun_zenith_deg;
    double cost;
  };
  for (const auto& [sun_zenith_deg, cost] :
       {Reference{0.0, 0.38242276}, Reference{45.0, 0.20786446}, Reference{85.0, 0.15304163}}) {
    const Direction sun{sun_zenith_deg, 90.0};
    const auto samples = sky_of(sun, hazy_layer);
    const FitReport report = fit_perez(samples, sun_zenith_deg * kRadiansPerDegree, samples[0].value, {});
    EXPECT_LE(report.cost, cost * (1.0 + 1e-6)) << sun_zenith_deg;
    EXPECT_NEAR(report.cost,
                perez_cost(samples, sun_zenith_deg * kRadiansPerDegree, samples[0].value,
                           ResidualKind::relative, report.coefficients),
                1e-12 * report.cost);
  }
}

// No coefficient moved by a thousandth, within its bounds, lowers the cost.
void expect_minimum(const FitReport& report, const std::vector<SkySample>& samples, double sun_zenith_rad) {
  const FitOptions options;
  for (std::size_t i = 0; i < 5; ++i)
    for (const double factor : {0.999, 1.001}) {
      std::array<double, 5> k = report.coefficients.values();
      k[i] *= factor;
      k[1] = std::clamp(k[1], options.B_lower, options.B_upper);
      k[3] = std::clamp(k[3], options.D_lower, options.D_upper);
      EXPECT_GE(perez_cost(samples, sun_zenith_rad, report.zenith_value, ResidualKind::relative,
                           {k[0], k[1], k[2], k[3], k[4]}),
                report.cost * (1.0 - 1e-12))
          << kPerezNames[i] << " times " << factor;
    }
}

// A measured sky whose zenith reads 1.8 times too high: CIE sky type 12, the sun at 60°. Levenberg-Marquardt
// creeps along a hyperbola A + 1 ~ B and had not arrived after 200 iterations; the minimum is at B's
// bound, 6.532345853.
TEST(FitPerez, ArrivesAtTheEndOfACurvedValley) {
  const double sun_zenith = 60.0 * kRadiansPerDegree;
  const double level = 1.0 - 10.0 * std::exp(-1.5 * kPi);
  const PerezCoefficients clear{-1.0, -0.32, 10.0 / level, -3.0, 0.45 / level};
  std::vector<SkySample> samples{{0.0, sun_zenith, 1.8, 1.0}};
  const std::pair<double, int> rings[] = {{84.0, 30}, {72.0, 30}, {60.0, 24}, {48.0, 24},
                                          {36.0, 18}, {24.0, 12}, {12.0, 6}};
  for (const auto& [zenith_deg, count] : rings)
    for (int i = 0; i < count; ++i) {
      const double zenith = zenith_deg * kRadiansPerDegree;
      const double gamma = angle_between({zenith_deg, 360.0 * i / count}, {60.0, 160.0});
      samples.push_back({zenith, gamma, perez_relative(clear, zenith, gamma, sun_zenith), 1.0});
    }
  const FitReport report = fit_perez(samples, sun_zenith, 1.8, {});
  EXPECT_EQ(report.termination, Termination::converged) << report.message;
  EXPECT_TRUE(report.at_bound[1]);
  EXPECT_NEAR(report.cost, 6.532345853, 1e-8);  // 2e-6 below where the creeping stopped
  expect_minimum(report, samples, sun_zenith);
}

TEST(FitPerez, SaysThatItDidNotConverge) {
  const Direction sun{60.0, 90.0};
  const auto samples = sky_of(sun, hazy_layer);
  FitOptions options;
  options.max_iterations = 1;
  const FitReport report = fit_perez(samples, sun.zenith_deg * kRadiansPerDegree, samples[0].value, options);
  EXPECT_EQ(report.termination, Termination::no_convergence);
  EXPECT_NE(report.message.find("maximum number of iterations"), std::string::npos);
}

TEST(FitPerez, IsNeverWorseThanItsStarts) {
  const Direction sun{60.0, 90.0};
  const auto samples = sky_of(sun, hazy_layer);
  const double sun_zenith = sun.zenith_deg * kRadiansPerDegree;
  const FitReport report = fit_perez(samples, sun_zenith, samples[0].value, {});
  for (const double turbidity : {2.0, 3.0, 6.0})
    EXPECT_LE(report.cost, perez_cost(samples, sun_zenith, samples[0].value, ResidualKind::relative,
                                      preetham1999_coefficients(turbidity).Y));
}

TEST(FitPerez, MirrorSunsAndOtherOrdersGiveTheSameBits) {
  for (const double sun_zenith : {30.0, 90.0}) {
    const auto east = sky_of({sun_zenith, 90.0}, hazy_layer);
    auto west = sky_of({sun_zenith, 270.0}, hazy_layer);
    // A simulation gives mirrored views the same value; these differ by the rounding of γ.
    const double rad = sun_zenith * kRadiansPerDegree;
    const FitReport from_east = fit_perez(east, rad, east[0].value, {});
    const FitReport from_west = fit_perez(west, rad, west[0].value, {});
    expect_coefficients(from_west.coefficients, from_east.coefficients, 1e-6);
    auto shuffled = east;
    std::reverse(shuffled.begin() + 1, shuffled.end());
    EXPECT_EQ(fit_perez(shuffled, rad, east[0].value, {}).coefficients, from_east.coefficients);
  }
}

TEST(FitPerez, ScaleDoesNotMatter) {
  const auto dim = perez_sky_of({45.0, 0.0}, {-0.9, -0.2, 5.0, -2.5, 0.4}, 1e-3);
  const FitReport report = fit_perez(dim, 45.0 * kRadiansPerDegree, 1e-3, {});
  expect_coefficients(report.coefficients, {-0.9, -0.2, 5.0, -2.5, 0.4}, 1e-6);
  EXPECT_EQ(report.zenith_value, 1e-3);
}

// Without an aureole D means nothing, without gradation B.
TEST(FitPerez, FlagsWhatTheDataDoNotDetermine) {
  const Direction sun{50.0, 90.0};
  const auto samples = perez_sky_of(sun, {0.0, -1.0, 0.0, -1.0, 0.7}, 1.0);
  const FitReport report = fit_perez(samples, sun.zenith_deg * kRadiansPerDegree, 1.0, {});
  EXPECT_FALSE(report.determined[1]);
  EXPECT_FALSE(report.determined[3]);
  EXPECT_TRUE(report.determined[4]);
  EXPECT_NEAR(report.coefficients.E, 0.7, 1e-6);
}

// With the sun at the zenith θ = γ, and along the sun's meridian γ = |θ - θ_s|: the factors are not told
// apart.
TEST(FitPerez, FlagsTheSunAtTheZenith) {
  const PerezCoefficients k{-0.3, -0.3, 0.5, -1.5, 0.3};
  const FitReport report = fit_perez(perez_sky_of({0.0, 0.0}, k, 1.0), 0.0, 1.0, {});
  EXPECT_LT(report.rmse, 1e-6);
  for (const bool determined : report.determined) EXPECT_FALSE(determined);
  std::vector<SkySample> meridian;
  for (int zenith_deg = 0; zenith_deg <= 90; zenith_deg += 5) {
    const double zenith = zenith_deg * kRadiansPerDegree;
    const double gamma = std::abs(zenith - 0.5);
    meridian.push_back({zenith, gamma, perez_relative(k, zenith, gamma, 0.5), 1.0});
  }
  for (const bool determined : fit_perez(meridian, 0.5, 1.0, {}).determined) EXPECT_FALSE(determined);
}

TEST(FitPerez, RespectsBounds) {
  FitOptions options;
  options.D_lower = -2.0;
  const auto samples = perez_sky_of({45.0, 0.0}, {-0.9, -0.2, 5.0, -2.5, 0.4}, 1.0);
  const FitReport report = fit_perez(samples, 45.0 * kRadiansPerDegree, 1.0, options);
  EXPECT_EQ(report.coefficients.D, -2.0);
  EXPECT_TRUE(report.at_bound[3]);
  EXPECT_FALSE(report.determined[3]);
  EXPECT_LT(report.coefficients.B, 0.0);
}

// Standard errors against the scatter of fits to noisy copies of a sky.
TEST(FitPerez, StandardErrorsAreThoseOfNoisyData) {
  const PerezCoefficients k{-0.99, -0.3, 10.0, -3.0, 0.45};
  const Direction sun{60.0, 90.0};
  const double sun_zenith = sun.zenith_deg * kRadiansPerDegree;
  const auto clean = perez_sky_of(sun, k, 1.0);
  constexpr int kCopies = 40;
  constexpr double kNoise = 0.01;
  unsigned state = 12345;
  const auto uniform = [&state] {  // Numerical Recipes' generator: the same numbers everywhere
    state = 1664525u * state + 1013904223u;
    return (state >> 8) / 16777216.0;
  };
  double squares = 0.0;
  double predicted = 0.0;
  for (int copy = 0; copy < kCopies; ++copy) {
    auto noisy = clean;
    for (std::size_t i = 1; i < noisy.size(); ++i)
      noisy[i].value *= 1.0 + kNoise * std::sqrt(12.0) * (uniform() - 0.5);
    const FitReport report = fit_perez(noisy, sun_zenith, 1.0, {});
    squares += std::pow(report.coefficients.D - k.D, 2);
    predicted += report.standard_error[3];
  }
  // 40 copies know a standard deviation to 1/√80 = 11 %; three of those.
  EXPECT_NEAR(std::sqrt(squares / kCopies) / (predicted / kCopies), 1.0, 0.34);
}

TEST(FitPerez, RefusesWhatItCannotFit) {
  const auto good = perez_sky_of({45.0, 0.0}, {-0.9, -0.2, 5.0, -2.5, 0.4}, 1.0);
  const auto broken = [&](auto change) {
    auto samples = good;
    change(samples);
    return samples;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double sun = 45.0 * kRadiansPerDegree;
  EXPECT_THROW(fit_perez(broken([](auto& s) { s.resize(5); }), sun, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(broken([](auto& s) { s[3].value = 0.0; }), sun, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(broken([&](auto& s) { s[3].value = nan; }), sun, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(broken([](auto& s) { s[3].weight = -1.0; }), sun, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(broken([](auto& s) { s[3].zenith_rad = 2.0; }), sun, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(broken([&](auto& s) { s[3].gamma_rad = nan; }), sun, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(good, nan, 1.0, {}), InputError);
  EXPECT_THROW(fit_perez(good, sun, 0.0, {}), InputError);
  FitOptions options;
  options.B_upper = 0.1;
  EXPECT_THROW(fit_perez(good, sun, 1.0, options), InputError);
}

TEST(FitPerez, PrintsNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto samples = sky_of({0.0, 0.0}, hazy_layer);
  fit_perez(samples, 0.0, samples[0].value, {});
  // Values that overflow on the way: Ceres would warn of every residual that is not finite.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int sky = 0; sky < 5; ++sky) {
    auto wild = samples;
    for (SkySample& sample : wild) sample.value = std::exp(400.0 * any(random));
    try {
      fit_perez(wild, 0.0, wild[0].value, {});
    } catch (const WorkError&) {
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace skylut
