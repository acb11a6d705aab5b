#include "skylut/sky/refracted_sun.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/sky/sun_disc.hpp"
#include "skylut/sky/sun_irradiance.hpp"
#include "skylut/transfer/direct_beam.hpp"
#include "skylut/transfer/refraction.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

std::shared_ptr<const Atmosphere> standard_air(bool refraction) {
  AtmosphereOptions options;
  options.refraction = refraction;
  options.aerosol = load_aerosol(test::context, "rural", std::nullopt);
  return std::make_shared<const Atmosphere>(test::context, load_profile(test::context, "ussa1976"), options);
}

SkyScene scene_at(double sun_zenith_deg, bool refraction = true) {
  static const std::shared_ptr<const Atmosphere> air[] = {standard_air(false), standard_air(true)};
  SkyScene scene;
  scene.atmosphere = air[refraction ? 1 : 0];
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  scene.suns = {{sun_zenith_deg, 180.0}};
  scene.wavelengths = WavelengthGrid(545.0, 555.0, 5.0);
  return scene;
}

// Published: Kasten and Young 1989, doi:10.1364/AO.28.004735, by ray tracing through the standard atmosphere
// of 1972 at 700 nm; their formula. At the horizon it gives 37.92; the 1976 standard by its own formulas,
// integrated finely along the ray at 550 nm, 38.16 (a separate program).
TEST(RefractedSun, AirMass) {
  const Atmosphere& air = *scene_at(0.0).atmosphere;
  const OpticalColumn column = air.column(550.0, 0.0);
  const std::vector<double>& depth = column.scatterers.front().scattering_depth;
  const auto mass_at = [&](double apparent_deg) {
    const auto path = sight_path_factors(air.shells(), 0.0, apparent_deg);
    double mass = 0.0;
    for (std::size_t i = 0; i < depth.size(); ++i) mass += depth[i] * path.value()[i];
    return mass / air.rayleigh_depth(550.0);
  };
  for (const double apparent_deg : {0.0, 60.0, 80.0, 85.0, 88.0, 89.0}) {
    const double published = 1.0 / (std::cos(apparent_deg * kRadiansPerDegree) +
                                    0.50572 * std::pow(90.0 - apparent_deg + 6.07995, -1.6364));
    EXPECT_NEAR(mass_at(apparent_deg) / published, 1.0, 3e-3) << apparent_deg;
  }
  EXPECT_NEAR(mass_at(90.0) / 38.16, 1.0, 1e-3);
  EXPECT_NEAR(mass_at(90.0) / 37.92, 1.0, 6e-3);
}

// The almanacs' 34' of mean refraction at the horizon is for 10 °C and 1010 hPa; 15 °C and 1013 hPa have 1.5
// % less: 0.55 deg. At 45 deg, tan z times 58.2" (Allen 1973 for 15 °C: 57.1").
TEST(RefractedSun, Angles) {
  const Shells& shells = scene_at(0.0).atmosphere->shells();
  EXPECT_NEAR(last_sun_zenith_deg(shells, 0.0) - 90.0, 0.55, 0.01);
  EXPECT_NEAR((45.0 - apparent_sun(shells, 0.0, 45.0).zenith_deg) * 3600.0, 57.1, 0.6);
}

// Setting: the lower edge is lifted more than the upper one, blue more than red. Bennett 1982,
// doi:10.1017/S0373463300022037: 34.0' at the horizon and 28.9' at 27' (15 °C, 1013 hPa): 5.1' of 32' less
// high.
TEST(RefractedSun, DiscIsFlattened) {
  const RefractedSun sun = *refracted_sun(scene_at(90.28));  // its lower edge is on the horizon
  EXPECT_NEAR(sun.vertical_diameter_deg / sun.horizontal_diameter_deg, 0.842, 0.008);
  EXPECT_NEAR(sun.apparent_zenith_deg + 0.5 * sun.vertical_diameter_deg, 90.0, 0.01);
  EXPECT_NEAR(sun.blue_refraction_deg / sun.red_refraction_deg, 1.015, 0.004);
  const RefractedSun high = *refracted_sun(scene_at(30.0));
  EXPECT_NEAR(high.vertical_diameter_deg / high.horizontal_diameter_deg, 1.0, 1e-3);
  EXPECT_FALSE(refracted_sun(scene_at(90.0, false)));
}

// By ray tracing through air of this kind: transmittance along straight rays over that along bent ones at the
// same true sun, 550 nm. The disc's flattening, which takes irradiance, is not in it.
TEST(RefractedSun, StraightLightIsTooFaint) {
  SunIrradianceOptions beam;
  beam.diffuse = false;
  const auto direct = [&](double sun_deg, bool refraction) {
    const SkyScene scene = scene_at(sun_deg, refraction);
    return simulate_sun(test::context, scene, beam, {}).direct_normal[1] /
           apparent_sun(scene.atmosphere->shells(), 0.0, sun_deg).concentration;
  };
  for (const auto& [sun_deg, published, bar] : {std::tuple{80.0, -0.006, 0.001},
                                                {85.0, -0.037, 0.004},
                                                {87.0, -0.11, 0.01},
                                                {88.0, -0.21, 0.01},
                                                {89.0, -0.45, 0.02},
                                                {90.0, -0.83, 0.015}})
    EXPECT_NEAR(direct(sun_deg, false) / direct(sun_deg, true) - 1.0, published, bar) << sun_deg;
  EXPECT_GT(direct(90.5, true), 0.0);
  EXPECT_EQ(direct(90.5, false), 0.0);
  EXPECT_EQ(direct(90.6, true), 0.0);
}

// The disc's light is the beam's where it is all in the sky, and both are spread alike; its points hold it.
TEST(RefractedSun, DiscAndBeamAgree) {
  SunIrradianceOptions beam;
  beam.diffuse = false;
  for (const auto& [sun_deg, bar] : {std::pair{40.0, 1e-4}, {80.0, 2e-3}}) {
    const SkyScene scene = scene_at(sun_deg);
    const SunDisc disc(test::context, scene);
    const SunIrradiance sun = simulate_sun(test::context, scene, beam, {});
    EXPECT_NEAR(disc.direct_normal()[1] / sun.direct_normal[1], 1.0, bar) << sun_deg;
    EXPECT_EQ(disc.visible_part(), 1.0);
  }
  const SunDisc setting(test::context, scene_at(90.5));
  EXPECT_GT(setting.visible_part(), 0.4);
  EXPECT_LT(setting.visible_part(), 0.8);
  double sum = 0.0;
  const SunDiscPoints points = setting.points(0.02);
  for (std::size_t i = 1; i < points.irradiance.size(); i += setting.wavelengths().size())
    sum += points.irradiance[i];
  EXPECT_NEAR(sum / setting.direct_normal()[1], 1.0, 1e-6);
  for (const Direction& point : points.directions) EXPECT_LE(point.zenith_deg, 90.0 + 1e-6);
}

}  // namespace
}  // namespace skylut
