#include "skylut/forms/model_error.hpp"

#include <gtest/gtest.h>

#include <set>

#include "skylut/models/preetham1999.hpp"
#include "support/model_skies.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

const test::ModelSkies kSkies(std::make_shared<const Preetham1999>(),
                              {{0.0}, TurbidityKind::preetham_t, {3.0}, {30.0, 70.0}});

TEST(ModelError, IsNoneAgainstItself) {
  for (const SkyError& error : sky_errors(Preetham1999(), kSkies.given(test::context, checking_views))) {
    EXPECT_EQ(error.rms_Y_rel, 0.0);
    EXPECT_EQ(error.worst_Y_rel, 0.0);
  }
}

TEST(ModelError, IsWhatWasPutIn) {
  std::vector<TrainingSky> skies = kSkies.given(test::context, checking_views);
  for (Yxy& colour : skies[0].colours) colour = {colour.Y / 1.25, colour.x - 0.01, colour.y + 0.02};
  skies[1].colours[7].Y *= 2.0;
  const std::vector<SkyError> errors = sky_errors(Preetham1999(), skies);
  EXPECT_NEAR(errors[0].rms_Y_rel, 0.25, 1e-12);
  EXPECT_NEAR(errors[0].mean_Y_rel, 0.25, 1e-12);
  EXPECT_NEAR(errors[0].rms_x, 0.01, 1e-12);
  EXPECT_NEAR(errors[0].rms_y, 0.02, 1e-12);
  EXPECT_NEAR(errors[1].worst_Y_rel, -0.5, 1e-12);
  EXPECT_EQ(errors[1].worst_view, skies[1].dome.views[7]);
  const auto summary = error_summary(errors);
  EXPECT_EQ(summary["skies"], 2);
  EXPECT_EQ(summary["rms_Y_rel"]["worst"], 0.25);
  EXPECT_EQ(summary["worst_sky"]["sun_zenith_deg"], 30.0);
}

TEST(ModelError, ConditionsAreSpreadOverTheDomain) {
  ModelInfo domain;
  domain.altitude_km = {0.0, 20.0, "km"};
  domain.turbidity = {0.1, 1.0, ""};
  domain.albedo = Range{0.0, 1.0, ""};
  domain.sun_zenith_deg = {0.0, 90.0, "deg"};
  const SkyAxes axes{{0.0, 1.0, 20.0}, TurbidityKind::aod500, {0.1, 0.2, 1.0}, {0.0}};
  const std::vector<SoughtSky> skies = spread_conditions(domain, axes, 8, 8);
  ASSERT_EQ(skies.size(), 64u);
  std::set<double> loads;
  int low = 0;
  int low_sun = 0;
  for (const SoughtSky& sky : skies) {
    EXPECT_TRUE(domain.altitude_km.holds(sky.altitude_km));
    EXPECT_TRUE(domain.turbidity.holds(sky.turbidity.value));
    EXPECT_TRUE(domain.albedo->holds(*sky.albedo));
    EXPECT_TRUE(domain.sun_zenith_deg.holds(sky.sun.zenith_deg));
    loads.insert(sky.turbidity.value);
    low += sky.altitude_km < 1.0 ? 1 : 0;
    low_sun += sky.sun.zenith_deg > 45.0 ? 1 : 0;
  }
  EXPECT_EQ(loads.size(), 8u);
  EXPECT_NEAR(low, 32, 3);  // half of the nodes' intervals lies below the second node
  EXPECT_NEAR(low_sun, 32, 3);
}

}  // namespace
}  // namespace skylut
