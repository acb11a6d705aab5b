#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"

namespace skylut {
namespace {

const std::vector<RelativeView> kViews = {{0.0, 0.0}, {60.0, 90.0}, {90.0, 0.0}, {90.0, 90.0}, {90.0, 180.0}};
const std::vector<double> kObservers_km = {0.0, 12.0};

OpticalColumn rayleigh() { return test::column_of({.rayleigh_depth = 0.15, .absorption_depth = 0.02, .ground_albedo = 0.2}); }
OpticalColumn hazy() {
  return test::column_of({.rayleigh_depth = 0.1, .haze_depth = 0.2, .haze_scattering_albedo = 0.95, .ground_albedo = 0.2});
}

/// Logarithm of the radiance under each sun.
std::vector<double> log_radiance(const SkyRadiance& sky, std::size_t suns, std::size_t column, std::size_t observer, std::size_t view) {
  std::vector<double> logs;
  for (std::size_t sun = 0; sun < suns; ++sun) logs.push_back(std::log(static_cast<double>(sky.at(column, observer, sun, view))));
  return logs;
}

// Nothing happens when the sun crosses the horizon: over 0.01° the logarithm goes on by the slope, whose
// change over 0.01° is 0.01 times that over 1°.
TEST(Twilight, NoStepAtSunset) {
  const OpticalColumn columns[] = {rayleigh(), hazy()};
  const SkyRadiance sky = test::solve(test::earth(), columns, {kObservers_km, {89.98, 89.99, 90.0, 90.01, 90.02}, kViews});
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t o = 0; o < kObservers_km.size(); ++o)
      for (std::size_t v = 0; v < kViews.size(); ++v) {
        const std::vector<double> logs = log_radiance(sky, 5, c, o, v);
        const double slope = (logs[4] - logs[0]) / 4.0;
        // Largest slope 1 per degree; single precision of radiances 2e-7; a change of slope of 1 per degree
        // per degree adds 1e-4.
        EXPECT_LT(std::abs(slope), 0.01);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(logs[i + 1] - logs[i], slope, 2e-4) << c << o << v << " " << i;
      }
}

// From 84° to 96° in quarter degrees: log radiance is smooth, and the zenith only gets darker.
TEST(Twilight, SmoothAndDarkening) {
  std::vector<double> suns;
  for (double sun = 84.0; sun <= 96.0; sun += 0.25) suns.push_back(sun);
  const OpticalColumn columns[] = {rayleigh(), hazy()};
  const SkyRadiance sky = test::solve(test::earth(), columns, {kObservers_km, suns, kViews});
  double worst = 0.0;
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t o = 0; o < kObservers_km.size(); ++o)
      for (std::size_t v = 0; v < kViews.size(); ++v) {
        const std::vector<double> logs = log_radiance(sky, suns.size(), c, o, v);
        for (std::size_t i = 1; i < logs.size(); ++i) {
          if (v == 0) EXPECT_LT(logs[i], logs[i - 1]) << c << " " << o << ", sun " << suns[i];
          if (i + 1 == logs.size()) continue;
          const double bend = logs[i + 1] - 2.0 * logs[i] + logs[i - 1];
          worst = std::max(worst, std::abs(bend));
          EXPECT_LT(std::abs(bend), 0.05) << c << " " << o << " " << v << ", sun " << suns[i];
        }
      }
  RecordProperty("worst_second_difference", std::to_string(worst));
}

}  // namespace
}  // namespace skylut
