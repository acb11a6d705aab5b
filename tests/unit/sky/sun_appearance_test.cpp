#include "skylut/sky/sun_appearance.hpp"

#include <gtest/gtest.h>

#include "skylut/sky/sun_disc.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

SkyScene scene_at(double sun_zenith_deg, double aod500 = 0.1) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, aod500}};
  scene.suns = {{sun_zenith_deg, 180.0}};
  return scene;
}

SunAppearance disc_at(double sun_zenith_deg, double aod500 = 0.1) {
  const SkyScene scene = scene_at(sun_zenith_deg, aod500);
  const SunIrradiance sun = simulate_sun(test::context, scene, {false, 0.0}, {});
  return sun_appearance(test::context, sun, SunDisc(test::context, scene));
}

TEST(LightColour, OfWhiteAndOfNothing) {
  const PlanckianLocus locus(ColourMatching::load(test::context));
  const auto white = light_colour(locus, to_xyz(Yxy{1000.0, kD65_x, kD65_y}));
  ASSERT_TRUE(white);
  EXPECT_NEAR(white->rgb.r, 1000.0, 1e-9);
  EXPECT_NEAR(white->rgb.g, 1000.0, 1e-9);
  EXPECT_NEAR(white->rgb.b, 1000.0, 1e-9);
  EXPECT_NEAR(white->temperature->temperature_K, 6504.0, 3.0);
  EXPECT_FALSE(light_colour(locus, {}));
}

// Above the air the sun's CCT is 5900 K or so (ASTM G-173: 5910 K); through more and more air it reddens.
TEST(SunAppearance, RedderAndDimmerTheLower) {
  double last_K = 5900.0;
  double last_luminance = 1.96e9;
  for (const double sun_deg : {0.0, 60.0, 80.0, 87.0}) {
    const SunAppearance sun = disc_at(sun_deg);
    ASSERT_TRUE(sun.disc && sun.disc->temperature) << sun_deg;
    EXPECT_LT(sun.disc->temperature->temperature_K, last_K);
    EXPECT_LT(sun.mean_luminance_cd_m2, last_luminance);
    EXPECT_EQ(sun.visible_part, 1.0);
    last_K = sun.disc->temperature->temperature_K;
    last_luminance = sun.mean_luminance_cd_m2;
  }
  EXPECT_NEAR(disc_at(90.0).visible_part, 0.5, 1e-9);
  EXPECT_FALSE(disc_at(92.0).disc);
  EXPECT_EQ(disc_at(92.0).mean_luminance_cd_m2, 0.0);
}

// Illuminance is mean luminance times solid angle, for a disc and for a beam spread over one.
TEST(SunAppearance, LuminanceTimesSolidAngle) {
  const SkyScene scene = scene_at(50.0);
  const SunIrradiance sun = simulate_sun(test::context, scene, {false, 0.0}, {});
  const SunAppearance disc = sun_appearance(test::context, sun, SunDisc(test::context, scene));
  const SunAppearance beam = sun_appearance(test::context, sun, 1.0);
  const double lux = illuminance_lux(sun.direct_normal, sun.luminous_weight);
  EXPECT_NEAR(disc.mean_luminance_cd_m2 * sun_solid_angle_sr(1.0) / lux, 1.0, 1e-5);
  EXPECT_NEAR(beam.mean_luminance_cd_m2 * sun_solid_angle_sr(1.0) / lux, 1.0, 1e-12);
  EXPECT_NEAR(beam.disc->illuminance_lux / lux, 1.0, 1e-12);
  EXPECT_EQ(beam.visible_part, 1.0);
  EXPECT_NEAR(beam.angular_diameter_deg, 0.53313, 1e-5);
}

// A clear sky is bluer than its sun, and all its light is what simulate_sun sums.
TEST(SunAppearance, SkyIsBluerThanTheSun) {
  SkyScene scene = scene_at(45.0);
  scene.wavelengths = WavelengthGrid(380.0, 780.0, 20.0);
  const SunIrradiance sun = simulate_sun(test::context, scene, {}, {});
  const SunAppearance seen = sun_appearance(test::context, sun, SunDisc(test::context, scene));
  ASSERT_TRUE(seen.sky);
  EXPECT_NEAR(seen.sky->illuminance_lux / illuminance_lux(sun.diffuse_horizontal, sun.luminous_weight), 1.0,
              1e-12);
  EXPECT_LT(seen.sky->x, seen.disc->x);
  EXPECT_LT(seen.sky->y, seen.disc->y);
  EXPECT_GT(seen.sky->rgb.b, seen.sky->rgb.r);
  EXPECT_LT(seen.disc->rgb.b, seen.disc->rgb.r);
}

}  // namespace
}  // namespace skylut
