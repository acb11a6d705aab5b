#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

SkyRequest everywhere() {
  SkyRequest request;
  request.observer_altitudes_km = {0.0, 0.01, 1.0, 6.0, 12.0, 20.0, 30.0};
  for (double sun = 0.0; sun <= 96.0; sun += sun < 80.0 ? 16.0 : 1.0) request.sun_zeniths_deg.push_back(sun);
  for (const double zenith : {0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 88.0, 89.5, 90.0, 90.5, 92.0, 94.0, 96.0,
                              105.0, 130.0, 160.0, 180.0})
    for (const double azimuth : {0.0, 30.0, 90.0, 150.0, 180.0}) request.views.push_back({zenith, azimuth});
  return request;
}

template <class Check>
void for_each(const SkyRequest& request, std::size_t columns, const Check& check) {
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t o = 0; o < request.observer_altitudes_km.size(); ++o)
      for (std::size_t s = 0; s < request.sun_zeniths_deg.size(); ++s)
        for (std::size_t v = 0; v < request.views.size(); ++v) check(c, o, s, v);
}

TEST(SkyBounds, NoLightIsNegative) {
  std::vector<OpticalColumn> columns;
  for (const double albedo : {0.0, 1.0})
    for (test::Air air : {test::Air{.rayleigh_depth = 0.01}, test::Air{.rayleigh_depth = 0.6},
                          test::Air{.rayleigh_depth = 0.1, .haze_depth = 0.2, .haze_scattering_albedo = 0.9},
                          test::Air{.rayleigh_depth = 0.05,
                          .haze_depth = 2.0,
                          .haze_scattering_albedo = 0.95,
                          .haze_asymmetry = 0.85},
                          test::Air{.rayleigh_depth = 0.05,
                          .haze_depth = 1.0,
                          .haze_scattering_albedo = 0.4,
                          .haze_asymmetry = 0.75,
                          .absorption_depth = 3.0},
                          test::Air{.absorption_depth = 1.0}}) {
      air.ground_albedo = albedo;
      columns.push_back(test::column_of(air));
    }
  const SkyRequest request = everywhere();
  const SkyRadiance sky = test::solve(test::earth(), columns, request);
  int negative = 0;
  for_each(request, columns.size(), [&](std::size_t c, std::size_t o, std::size_t s, std::size_t v) {
    const float radiance = sky.at(c, o, s, v);
    if (radiance >= 0.0f && std::isfinite(radiance)) return;
    if (++negative <= 20)
      ADD_FAILURE() << radiance << ": column " << c << ", " << request.observer_altitudes_km[o] << " km, sun "
                    << request.sun_zeniths_deg[s] << ", view " << request.views[v].zenith_deg << " "
                    << request.views[v].relative_azimuth_deg;
  });
  EXPECT_EQ(negative, 0);
}

// Nothing scatters, nothing reflects: black, exactly. (The direct sun is not part of the radiance.)
TEST(SkyBounds, AbsorbersOverBlackGroundAreBlack) {
  const OpticalColumn columns[] = {test::column_of({.absorption_depth = 0.5}), test::column_of({})};
  const SkyRequest request = everywhere();
  const SkyRadiance sky = test::solve(test::earth(), columns, request);
  for_each(request, 2, [&](std::size_t c, std::size_t o, std::size_t s, std::size_t v) {
    EXPECT_EQ(sky.at(c, o, s, v), 0.0f);
  });
}

// Without air the ground shines with A/π μ0 of the place that is seen, and the sky is black.
TEST(SkyBounds, BareGroundIsLambertian) {
  const double albedo = 0.4;
  const OpticalColumn column = test::column_of({.ground_albedo = albedo});
  const SkyRequest request = everywhere();
  const SkyRadiance sky = test::solve(test::earth(), column, request);
  for_each(request, 1, [&](std::size_t, std::size_t o, std::size_t s, std::size_t v) {
    const double r = 6371.0 + request.observer_altitudes_km[o];
    const double zenith = request.views[v].zenith_deg * kRadiansPerDegree;
    const double sun = request.sun_zeniths_deg[s] * kRadiansPerDegree;
    const double along = r * std::cos(zenith);
    const double square = along * along - (r * r - 6371.0 * 6371.0);
    const bool ground = zenith > kPi / 2.0 && square >= 0.0;
    double expected = 0.0;
    if (ground) {
      const double distance = -along - std::sqrt(square);
      const double cos_scattering = std::cos(zenith) * std::cos(sun) +
                                    std::sin(zenith) * std::sin(sun) *
                                        std::cos(request.views[v].relative_azimuth_deg * kRadiansPerDegree);
      expected = albedo / kPi * std::max(0.0, (r * std::cos(sun) + distance * cos_scattering) / 6371.0);
    }
    // Single precision of cosines: 6e-8 of 1 where the sun is at the horizon of the place.
    EXPECT_NEAR(sky.at(0, o, s, v), expected, 1e-6 * expected + 2e-8)
        << request.observer_altitudes_km[o] << " km, sun " << request.sun_zeniths_deg[s] << ", view "
        << request.views[v].zenith_deg << " " << request.views[v].relative_azimuth_deg;
  });
}

// More orders of scattering only add light, and enough of them are all of it.
TEST(SkyBounds, OrdersAddUp) {
  const OpticalColumn column = test::column_of({.rayleigh_depth = 0.3, .ground_albedo = 0.3});
  const SkyRequest request{
      {0.0, 12.0}, {0.0, 60.0, 85.0, 92.0}, {{0.0, 0.0}, {80.0, 90.0}, {100.0, 40.0}, {180.0, 0.0}}};
  const SkyRadiance all = test::solve(test::earth(), column, request);
  std::vector<SkyRadiance> sums;
  for (const int orders : {1, 2, 3, 5, 30}) {
    TransferOptions options = test::unpolarised();
    options.scattering_orders = orders;
    sums.push_back(solve_sky_radiance(test::context, test::earth(), std::span(&column, 1), request, options));
  }
  for_each(request, 1, [&](std::size_t c, std::size_t o, std::size_t s, std::size_t v) {
    for (std::size_t i = 1; i < sums.size(); ++i)
      EXPECT_GE(sums[i].at(c, o, s, v), sums[i - 1].at(c, o, s, v) * (1.0f - 1e-6f)) << i;
    // The iteration stops at 1e-3 of the mean diffuse radiance.
    EXPECT_NEAR(sums.back().at(c, o, s, v) / all.at(c, o, s, v), 1.0, 1e-3) << o << s << v;
  });
}

}  // namespace
}  // namespace skylut
