#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"

namespace skylut {
namespace {

const std::vector<RelativeView> kViews = {{0.0, 0.0}, {60.0, 90.0}, {90.0, 0.0}, {90.0, 90.0}, {90.0, 150.0}};
const std::vector<double> kObservers_km = {0.0, 12.0};

OpticalColumn rayleigh() {
  return test::column_of({.rayleigh_depth = 0.15, .absorption_depth = 0.02, .ground_albedo = 0.2});
}
OpticalColumn hazy() {
  return test::column_of(
      {.rayleigh_depth = 0.1, .haze_depth = 0.2, .haze_scattering_albedo = 0.95, .ground_albedo = 0.2});
}

/// Logarithm of the radiance under each sun.
std::vector<double> log_radiance(const SkyRadiance& sky, std::size_t suns, std::size_t column,
                                 std::size_t observer, std::size_t view) {
  std::vector<double> logs;
  for (std::size_t sun = 0; sun < suns; ++sun)
    logs.push_back(std::log(static_cast<double>(sky.at(column, observer, sun, view))));
  return logs;
}

// Nothing happens when the sun crosses the horizon. (From the ground, the horizon opposite the sun is left
// out: the shadow swallows that whole ray at once, which is physics.)
TEST(Twilight, NoStepAtSunset) {
  const OpticalColumn columns[] = {rayleigh(), hazy()};
  const SkyRadiance sky =
      test::solve(test::earth(), columns, {kObservers_km, {89.98, 89.99, 90.0, 90.01, 90.02}, kViews});
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t o = 0; o < kObservers_km.size(); ++o)
      for (std::size_t v = 0; v + 1 < kViews.size(); ++v) {
        const std::vector<double> logs = log_radiance(sky, 5, c, o, v);
        const double slope = (logs[4] - logs[0]) / 4.0;
        EXPECT_LT(std::abs(slope), 0.01);
        // At the horizon beside the sun the shadow starts on the near air: in 0.01° it takes R · 0.01° = 1.1
        // km of a path of some 30 km, lit by a beam that has lost nine tenths on its way: 0.3 % at most.
        for (std::size_t i = 0; i < 4; ++i)
          EXPECT_NEAR(logs[i + 1] - logs[i], slope, v == 3 ? 3e-3 : 5e-4) << c << o << v << " " << i;
      }
}

// From 84° to 96° in quarter degrees the zenith only gets darker, and the logarithm bends nowhere but where
// the physics does (the planet's shadow crosses the line of sight): where `reference`, with its sun nodes
// every half degree, bends too. 1.5 %: half of the error allowed at such suns.
TEST(Twilight, SmoothAndDarkening) {
  std::vector<double> suns;
  for (double sun = 84.0; sun <= 96.0; sun += 0.25) suns.push_back(sun);
  const OpticalColumn columns[] = {rayleigh(), hazy()};
  const SkyRequest request{kObservers_km, suns, kViews};
  const TransferOptions fine = test::unpolarised(Quality::reference);
  const SkyRadiance sky = test::solve(test::earth(), columns, request);
  const SkyRadiance reference = solve_sky_radiance(test::context, test::earth(), columns, request, fine);
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t o = 0; o < kObservers_km.size(); ++o)
      for (std::size_t v = 0; v < kViews.size(); ++v) {
        const std::vector<double> logs = log_radiance(sky, suns.size(), c, o, v);
        const std::vector<double> fine_logs = log_radiance(reference, suns.size(), c, o, v);
        const auto bend = [](const std::vector<double>& of, std::size_t i) {
          return of[i + 1] - 2.0 * of[i] + of[i - 1];
        };
        for (std::size_t i = 1; i + 1 < logs.size(); ++i) {
          EXPECT_NEAR(bend(logs, i), bend(fine_logs, i), 0.015)
              << c << " " << kObservers_km[o] << " km, view " << kViews[v].zenith_deg << " "
              << kViews[v].relative_azimuth_deg << ", sun " << suns[i];
          if (kViews[v].zenith_deg == 0.0) {
            EXPECT_LT(logs[i + 1], logs[i]) << c << " " << o << ", sun " << suns[i];
            // No step at all there: the slope changes by less than 0.5 per degree in a degree.
            EXPECT_LT(std::abs(bend(logs, i)), 0.03) << c << " " << o << ", sun " << suns[i];
          }
        }
      }
}

// A low top of the atmosphere lies in the earth's shadow from a sun of 93° on: between sun nodes with some
// light and nodes with none, interpolation must not end below zero.
TEST(Twilight, NightIsNotNegative) {
  for (const double top_km : {5.0, 10.0, 20.0})
    for (const Quality quality : {Quality::draft, Quality::standard}) {
      const Shells shells{{0.0, top_km}, 6371.0};
      const OpticalColumn column{{0.21},
                                 {{std::make_shared<const RayleighPhaseFunction>(), {0.1}},
                                  {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.7), {0.09}}},
                                 0.2};
      SkyRequest request{
          {0.0, top_km}, {}, {{0.0, 0.0}, {60.0, 0.0}, {60.0, 180.0}, {89.0, 90.0}, {120.0, 0.0}}};
      for (double sun = 90.0; sun <= 96.0; sun += 0.25) request.sun_zeniths_deg.push_back(sun);
      TransferOptions options = test::unpolarised(quality);
      const SkyRadiance sky =
          solve_sky_radiance(test::context, shells, std::span(&column, 1), request, options);
      for (std::size_t o = 0; o < 2; ++o)
        for (std::size_t s = 0; s < request.sun_zeniths_deg.size(); ++s)
          for (std::size_t v = 0; v < request.views.size(); ++v)
            EXPECT_GE(sky.at(0, o, s, v), 0.0f)
                << top_km << " km " << o << " " << request.sun_zeniths_deg[s] << " " << v;
    }
}

}  // namespace
}  // namespace skylut
