#include "skylut/sky/sun_irradiance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sky_quadrature.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/direct_beam.hpp"
#include "skylut/transfer/plane_parallel.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

SkyScene scene_at(double sun_zenith_deg, double aod500 = 0.2) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, aod500}};
  scene.suns = {{sun_zenith_deg, 180.0}};
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 100.0);
  return scene;
}

// A sky of radiance 1 has the irradiance pi, a cone of half angle a has pi sin² a.
TEST(SkyQuadrature, UniformSky) {
  for (const double sun_deg : {0.0, 30.0, 75.0, 90.0, 96.0}) {
    double sum = 0.0;
    for (const double weight : hemisphere_quadrature(sun_deg).weight) sum += weight;
    EXPECT_NEAR(sum, kPi, 1e-9) << sun_deg;
    double cone = 0.0;
    for (const double weight : circumsolar_quadrature(sun_deg, 2.9).weight) cone += weight;
    EXPECT_NEAR(cone, kPi * std::pow(std::sin(2.9 * kRadiansPerDegree), 2), 1e-12);
  }
}

TEST(SkyQuadrature, ConeSurroundsTheSun) {
  for (const double sun_deg : {0.0, 30.0, 89.0})
    for (const RelativeView& view : circumsolar_quadrature(sun_deg, 5.0).views) {
      EXPECT_LT(angle_between({view.zenith_deg, view.relative_azimuth_deg}, {sun_deg, 0.0}),
                5.0 * kRadiansPerDegree);
      EXPECT_GE(view.relative_azimuth_deg, 0.0);
    }
}

// A bright narrow aureole, Henyey and Greenstein's with g = 0.95, against 96 nodes in its own polar angle:
// over the whole sphere it integrates to 4 pi, here to what lies above the horizon weighted by the cosine.
// Reference by the same nodes doubled twice in a separate program: the error of 16 is below 2e-4.
TEST(SkyQuadrature, AureoleAtTheZenith) {
  constexpr double g = 0.95;
  const SkyQuadrature sky = hemisphere_quadrature(0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < sky.views.size(); ++i) {
    const double cosine = std::cos(sky.views[i].zenith_deg * kRadiansPerDegree);
    sum += sky.weight[i] * (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
  }
  // 2 pi ∫₀¹ p(µ) µ dµ with b = 1 + g²: ∫ µ (b - 2gµ)^-1.5 dµ = (b - gµ) / (g² sqrt(b - 2gµ)).
  const double b = 1.0 + g * g;
  const double exact =
      2.0 * kPi * (1.0 - g * g) / (g * g) * ((b - g) / std::sqrt(b - 2.0 * g) - b / std::sqrt(b));
  EXPECT_NEAR(sum / exact, 1.0, 2e-4);
}

// Flat layers: the solver's radiances integrated over the sky against the plane-parallel solver's flux, which
// is good to 1e-5. 0.2 %: the radiances' own discretisation (0.1-0.3 %, plane_limit_test).
TEST(SunIrradiance, DiffuseIsTheFluxOfFlatLayers) {
  for (const double sun_deg : {0.0, 48.236, 75.0}) {
    SkyScene scene = scene_at(sun_deg);
    AtmosphereOptions flat;
    flat.planet_radius_km = 1e7;
    scene.atmosphere = test::standard_atmosphere(flat);
    const SunIrradiance sun = simulate_sun(test::context, scene, {}, {});
    const Atmosphere& air = *scene.atmosphere;
    for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
      double expected = 0.0;
      for (const BandColumn& term :
           air.band_columns({scene.wavelengths[i], scene.wavelengths.step_nm()}, 0.2)) {
        PlaneParallelRequest request;
        request.cos_sun_zenith = std::cos(sun_deg * kRadiansPerDegree);
        double depth = 0.0;
        for (const double layer : term.column.extinction_depth) depth += layer;
        request.output_depths = {depth};
        request.directions = {{-0.5, 0.0}};
        expected += term.weight * solve_plane_parallel(term.column, request).flux_down_diffuse[0];
      }
      EXPECT_NEAR(sun.diffuse_horizontal[i] / sun.extraterrestrial[i] / expected, 1.0, 2e-3)
          << sun_deg << " " << scene.wavelengths[i];
    }
  }
}

// The beam is the product of its constituents; each is Beer's law through the shells' paths.
TEST(SunIrradiance, DirectBeamIsTheProductOfTransmittances) {
  SkyScene scene = scene_at(80.0);
  scene.altitudes_km = {6.0};
  const SunIrradiance sun = simulate_sun(test::context, scene, {false, 0.0}, {});
  EXPECT_TRUE(sun.beam_arrives);
  EXPECT_TRUE(sun.diffuse_horizontal.empty());
  EXPECT_TRUE(sun.global_horizontal().empty());
  const Atmosphere& air = *scene.atmosphere;
  const auto path = beam_path_factors(air.shells(), 6.0, 80.0);
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    double product = sun.extraterrestrial[i];
    for (const ConstituentTransmittance& constituent : sun.transmittance) product *= constituent.band_mean[i];
    EXPECT_NEAR(sun.direct_normal[i] / product, 1.0, 1e-12);
    EXPECT_NEAR(
        sun.transmittance.front().band_mean[i],
        beam_transmittance(*path, air.column(scene.wavelengths[i], 0.0).scatterers[0].scattering_depth),
        1e-12);
  }
}

// The columns that diffuse light sees transmit the same beam: exactly where no line absorbs, within the fit
// of their few terms where lines do (0.005 (1 + m/2) of the light at m vertical amounts, twice that before a
// third term is taken, docs/air.md A24: 0.02 at m = 2).
TEST(SunIrradiance, TheColumnsOfTheSkyTransmitTheSameBeam) {
  SkyScene scene = scene_at(60.0);
  scene.wavelengths = WavelengthGrid(450.0, 750.0, 5.0);
  const SunIrradiance sun = simulate_sun(test::context, scene, {false, 0.0}, {});
  const Atmosphere& air = *scene.atmosphere;
  const auto path = beam_path_factors(air.shells(), 0.0, 60.0);
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    const double wavelength_nm = scene.wavelengths[i];
    double columns = 0.0;
    for (const BandColumn& term : air.band_columns({wavelength_nm, 5.0}, 0.2))
      columns += term.weight * beam_transmittance(*path, term.column.extinction_depth);
    const double beam = sun.direct_normal[i] / sun.extraterrestrial[i];
    EXPECT_NEAR(columns, beam, wavelength_nm < 495.0 ? 1e-9 : 0.02) << wavelength_nm;
  }
}

TEST(SunIrradiance, GlobalIsDirectOnTheHorizontalAndDiffuse) {
  const SunIrradiance sun = simulate_sun(test::context, scene_at(60.0), {}, {});
  const std::vector<double> global = sun.global_horizontal();
  for (std::size_t i = 0; i < global.size(); ++i)
    EXPECT_NEAR(global[i], 0.5 * sun.direct_normal[i] + sun.diffuse_horizontal[i], 1e-12);
}

// From 12 km the horizon dips 3.5 deg: the sun still shines at 92 deg and not at 94, the sky at both.
TEST(SunIrradiance, TwilightFromAHeight) {
  SkyScene scene = scene_at(92.0);
  scene.altitudes_km = {12.0};
  const SunIrradiance risen = simulate_sun(test::context, scene, {}, {});
  EXPECT_TRUE(risen.beam_arrives);
  EXPECT_GT(risen.direct_normal.back(), 0.0);
  EXPECT_EQ(risen.global_horizontal(), risen.diffuse_horizontal);
  scene.suns = {{94.0, 0.0}};
  const SunIrradiance set = simulate_sun(test::context, scene, {}, {});
  EXPECT_FALSE(set.beam_arrives);
  EXPECT_EQ(set.direct_normal.back(), 0.0);
  EXPECT_EQ(set.transmittance.front().band_mean.back(), 0.0);
  EXPECT_GT(set.diffuse_horizontal.front(), 0.0);
}

// Light around the sun: between nothing and the whole sky, and more from a wider cone.
TEST(SunIrradiance, CircumsolarLight) {
  const SkyScene scene = scene_at(45.0);
  const SunIrradiance narrow = simulate_sun(test::context, scene, {true, 1.0}, {});
  const SunIrradiance wide = simulate_sun(test::context, scene, {true, 2.9}, {});
  EXPECT_EQ(narrow.diffuse_horizontal, wide.diffuse_horizontal);
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    EXPECT_GT(narrow.circumsolar_normal[i], 0.0);
    // A flat aureole would grow with the solid angle, 8.4 times; a peaked one less.
    EXPECT_GT(wide.circumsolar_normal[i], 4.0 * narrow.circumsolar_normal[i]);
    EXPECT_LT(wide.circumsolar_normal[i], 8.5 * narrow.circumsolar_normal[i]);
    EXPECT_LT(wide.circumsolar_normal[i], 0.2 * wide.diffuse_horizontal[i]);
  }
}

TEST(SunIrradiance, DistanceAndThreads) {
  SkyScene scene = scene_at(45.0);
  Context one = test::context;
  one.threads = 1;
  const SunIrradiance mean = simulate_sun(one, scene, {}, {});
  EXPECT_EQ(simulate_sun(test::context, scene, {}, {}).diffuse_horizontal, mean.diffuse_horizontal);
  scene.sun_distance_au = 1.02;
  const SunIrradiance far = simulate_sun(one, scene, {}, {});
  EXPECT_NEAR(mean.direct_normal[0] / far.direct_normal[0], 1.02 * 1.02, 1e-12);
  // Radiances are single precision.
  EXPECT_NEAR(mean.diffuse_horizontal[0] / far.diffuse_horizontal[0], 1.02 * 1.02, 1e-6);
}

// All of the sun's light above the air: about 133 klx (solar illuminance constant 133.1 klx for ASTM G-173's
// spectrum; E-490 gives 133.3).
TEST(SunIrradiance, SolarIlluminanceConstant) {
  SkyScene scene = scene_at(0.0);
  scene.wavelengths = WavelengthGrid::visible();
  const SunIrradiance sun = simulate_sun(test::context, scene, {false, 0.0}, {});
  EXPECT_NEAR(illuminance_lux(sun.extraterrestrial, sun.luminous_weight), 133.1e3, 0.2e3);
  EXPECT_NEAR(broadband_W_m2(sun.extraterrestrial, sun.wavelengths), 662.0, 0.5);
}

TEST(SunIrradiance, RefusesWhatItCannotDo) {
  const auto refused = [](const SkyScene& scene, const SunIrradianceOptions& options) {
    EXPECT_THROW(simulate_sun(test::context, scene, options, {}), InputError);
  };
  refused(scene_at(100.0), {});
  refused(scene_at(181.0), {false, 0.0});
  refused(scene_at(45.0), {true, 11.0});
  SkyScene two = scene_at(45.0);
  two.suns.push_back({30.0, 0.0});
  refused(two, {});
  SkyScene high = scene_at(45.0);
  high.altitudes_km = {31.0};
  refused(high, {});
  EXPECT_NO_THROW(simulate_sun(test::context, scene_at(97.0), {false, 0.0}, {}));
}

}  // namespace
}  // namespace skylut
