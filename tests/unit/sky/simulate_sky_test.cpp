#include "skylut/sky/simulate_sky.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/atmosphere/solar_spectrum.hpp"
#include "skylut/colour/cie1931.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Few wavelengths and directions: these tests are about what goes where, not about accuracy.
SkyScene small_scene() {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0, 12.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.0}, {TurbidityKind::aod500, 0.3}};
  scene.suns = {{60.0, 90.0}, {60.0, 270.0}, {20.0, 0.0}};
  scene.directions = {{0.0, 0.0}, {50.0, 30.0}, {50.0, 330.0}, {90.0, 84.0}, {90.0, 276.0}};
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 100.0);
  return scene;
}

AtmosphereOptions without_water() {
  AtmosphereOptions options;
  options.water_cm = 0.0;
  return options;
}

TransferOptions draft() {
  TransferOptions options;
  options.discretisation = discretisation_of(Quality::draft);
  return options;
}

TEST(SimulateSky, OneMapPerAltitudeTurbidityAndSunInThatOrder) {
  const SkyScene scene = small_scene();
  const std::vector<SkyMap> maps = simulate_sky(test::context, scene, draft());
  ASSERT_EQ(maps.size(), 12u);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    EXPECT_EQ(maps[i].altitude_km, scene.altitudes_km[i / 6]);
    EXPECT_EQ(maps[i].turbidity.value, scene.turbidities[i / 3 % 2].value);
    EXPECT_EQ(maps[i].sun, scene.suns[i % 3]);
    EXPECT_EQ(maps[i].directions, scene.directions);
    EXPECT_EQ(maps[i].radiance.size(), 5u * 4u);
    EXPECT_EQ(maps[i].colour.size(), 5u);
  }
  EXPECT_GT(maps[0].colour[0].Y, maps[6].colour[0].Y) << "the zenith darkens with altitude";
}

TEST(SimulateSky, MirrorSunsSeeMirroredSkiesToTheLastBit) {
  const std::vector<SkyMap> maps = simulate_sky(test::context, small_scene(), draft());
  const SkyMap& east = maps[0];
  const SkyMap& west = maps[1];
  EXPECT_EQ(east.colour[0], west.colour[0]);
  EXPECT_EQ(east.colour[1], west.colour[2]);
  EXPECT_EQ(east.colour[3], west.colour[4]);
}

// A scene of one map is the same map of the larger scene, bit for bit.
TEST(SimulateSky, AMapDoesNotDependOnItsCompany) {
  SkyScene scene = small_scene();
  const SkyMap in_company = simulate_sky(test::context, scene, draft()).at(6 + 3 + 1);
  scene.altitudes_km = {12.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.3}};
  scene.suns = {{60.0, 270.0}};
  const std::vector<SkyMap> alone = simulate_sky(test::context, scene, draft());
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0].radiance, in_company.radiance);
  EXPECT_EQ(alone[0].colour, in_company.colour);
}

// Colour is that of the radiances in the map: what a reader of sky.csv computes from its L columns.
TEST(SimulateSky, ColourFollowsFromTheRadiances) {
  const SkyMap map = simulate_sky(test::context, small_scene(), draft()).front();
  const std::span<const float> spectrum = map.spectrum(1);
  const std::vector<double> radiance(spectrum.begin(), spectrum.end());
  const Yxy expected = to_yxy(ColourMatching::load(test::context).integrate(map.wavelengths, radiance));
  EXPECT_NEAR(map.colour[1].Y / expected.Y, 1.0, 1e-12);  // the order of a sum of a few terms
  EXPECT_NEAR(map.colour[1].x, expected.x, 1e-12);
  EXPECT_NEAR(map.colour[1].y, expected.y, 1e-12);
}

// Bands of lines are several lanes: their weighted sum is darker than without the gas, depends on no thread,
// and a map still not on its company.
TEST(SimulateSky, BandsOfLines) {
  SkyScene scene = small_scene();
  scene.wavelengths = WavelengthGrid(690.0, 720.0, 10.0);
  const TransferOptions options = draft();
  Context context = test::context;
  context.threads = 1;
  const std::vector<SkyMap> one = simulate_sky(context, scene, options);
  context.threads = 3;
  const std::vector<SkyMap> three = simulate_sky(context, scene, options);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].radiance, three[i].radiance);
  scene.turbidities.erase(scene.turbidities.begin());
  EXPECT_EQ(simulate_sky(test::context, scene, options)[0].radiance, one[3].radiance);
  scene.atmosphere = test::standard_atmosphere(without_water());
  const SkyMap dry = simulate_sky(test::context, scene, options)[0];
  // 720 nm (fourth band): water takes 12 % from the vertical and more from slant paths.
  EXPECT_LT(one[3].spectrum(1)[3], 0.9 * dry.spectrum(1)[3]);
  EXPECT_GT(one[3].spectrum(1)[3], 0.6 * dry.spectrum(1)[3]);
}

// Light falls with the square of the sun's distance.
TEST(SimulateSky, DistanceToTheSun) {
  SkyScene scene = small_scene();
  const SkyMap mean = simulate_sky(test::context, scene, draft()).front();
  scene.sun_distance_au = 1.02;
  const SkyMap far = simulate_sky(test::context, scene, draft()).front();
  EXPECT_NEAR(far.colour[0].Y * 1.02 * 1.02 / mean.colour[0].Y, 1.0, 1e-6);  // radiances are 32-bit floats
}

TEST(SimulateSky, RefusesWhatItCannotDo) {
  const auto refused = [](const std::function<void(SkyScene&)>& spoil) {
    SkyScene scene = small_scene();
    spoil(scene);
    EXPECT_THROW(simulate_sky(test::context, scene, draft()), InputError);
  };
  refused([](SkyScene& scene) { scene.altitudes_km = {31.0}; });
  refused([](SkyScene& scene) { scene.altitudes_km = {-1.0}; });
  refused([](SkyScene& scene) { scene.altitudes_km = {std::nan("")}; });
  refused([](SkyScene& scene) { scene.suns = {{100.0, 0.0}}; });
  refused([](SkyScene& scene) { scene.directions = {{181.0, 0.0}}; });
  refused([](SkyScene& scene) { scene.directions.clear(); });
  refused([](SkyScene& scene) { scene.turbidities = {{TurbidityKind::aod500, -0.1}}; });
}

}  // namespace
}  // namespace skylut
