#include "geometry/outside_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"

namespace skylut::transfer {
namespace {

// The line and the sun keep their angle; where they enter, the law of sines gives the view.
TEST(OutsideView, AnglesWhereTheLineEnters) {
  const ViewAndSun outside{114.0, 70.0, 130.0};
  const auto entry = view_from_entry(6371.0, 100.0, 500.0, outside);
  ASSERT_TRUE(entry);
  const auto cos_between = [](const ViewAndSun& v) {
    return std::cos(v.view_zenith_deg * kRadiansPerDegree) * std::cos(v.sun_zenith_deg * kRadiansPerDegree) +
           std::sin(v.view_zenith_deg * kRadiansPerDegree) * std::sin(v.sun_zenith_deg * kRadiansPerDegree) *
               std::cos(v.relative_azimuth_deg * kRadiansPerDegree);
  };
  EXPECT_NEAR(cos_between(*entry), cos_between(outside), 1e-12);
  EXPECT_NEAR(std::sin(entry->view_zenith_deg * kRadiansPerDegree) * 6471.0,
              std::sin(114.0 * kRadiansPerDegree) * 6871.0, 1e-9);
}

TEST(OutsideView, BesideTheAirIsNothing) {
  EXPECT_FALSE(view_from_entry(6371.0, 100.0, 500.0, {90.0, 30.0, 0.0}));
  EXPECT_FALSE(view_from_entry(6371.0, 100.0, 500.0, {30.0, 30.0, 0.0}));
  EXPECT_FALSE(view_from_entry(6371.0, 100.0, 500.0, {109.5, 30.0, 0.0}));  // asin(6471/6871) = 70.36
  EXPECT_TRUE(view_from_entry(6371.0, 100.0, 500.0, {109.7, 30.0, 0.0}));
}

// An observer a metre above the top sees what one just below it does: limb, ground and, upwards, nothing.
TEST(OutsideView, ContinuesTheSkyAtTheTop) {
  const OpticalColumn column =
      test::column_of({.rayleigh_depth = 0.2, .haze_depth = 0.1, .ground_albedo = 0.3});
  std::vector<Sight> sights;
  for (const double altitude : {100.0, 100.001})
    for (const double sun : {30.0, 85.0})
      for (const double view : {91.0, 96.0, 99.0, 120.0, 180.0})
        sights.push_back({altitude, sun, {view, 60.0}});
  TransferOptions options;
  options.discretisation.sun_bands = false;
  const SkyRadiance sky = solve_sky_radiance(test::context, test::earth(), {&column, 1}, sights, options);
  const std::size_t half = sights.size() / 2;
  for (std::size_t i = 0; i < half; ++i)
    EXPECT_NEAR(sky.at(0, half + i) / sky.at(0, i), 1.0f, 2e-3f) << sights[i].view.zenith_deg;
}

// From far away: the disc is lit on the sun's side and black on the other and beside it.
TEST(OutsideView, ThePlanetFromFar) {
  const OpticalColumn column = test::column_of({.rayleigh_depth = 0.1, .ground_albedo = 0.3});
  const double limb_deg = 180.0 - std::asin(6371.0 / 390000.0) * kDegreesPerRadian;
  const std::vector<Sight> sights{{383629.0, 90.0, {limb_deg + 0.4, 0.0}},
                                  {383629.0, 90.0, {limb_deg + 0.4, 180.0}},
                                  {383629.0, 90.0, {limb_deg - 0.1, 0.0}},
                                  {383629.0, 0.0, {180.0, 0.0}},
                                  {383629.0, 180.0, {180.0, 0.0}}};
  const SkyRadiance sky = solve_sky_radiance(test::context, test::earth(), {&column, 1}, sights, {});
  EXPECT_GT(sky.at(0, 0), 0.02f);
  EXPECT_LT(sky.at(0, 1), 1e-6f);
  EXPECT_EQ(sky.at(0, 2), 0.0f);
  EXPECT_NEAR(sky.at(0, 3), 0.3f / 3.14159f, 0.02f);
  EXPECT_LT(sky.at(0, 4), 1e-6f);
}

}  // namespace
}  // namespace skylut::transfer
