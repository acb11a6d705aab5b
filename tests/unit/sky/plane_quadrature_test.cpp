#include "plane_quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "skylut/core/constants.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Of a radiance that depends on the view relative to the sun.
double integral(const SkyQuadrature& quadrature, const std::function<double(const RelativeView&)>& radiance) {
  double sum = 0.0;
  for (std::size_t i = 0; i < quadrature.views.size(); ++i)
    sum += quadrature.weight[i] * radiance(quadrature.views[i]);
  return sum;
}

double both(const TiltedPlane& plane, const Direction& sun, double horizon_deg,
            const std::function<double(const RelativeView&)>& radiance) {
  return integral(plane_quadrature(plane, PlanePart::sky, sun, horizon_deg), radiance) +
         integral(plane_quadrature(plane, PlanePart::ground, sun, horizon_deg), radiance);
}

double uniform(const RelativeView&) { return 1.0; }

// A uniform sky gives pi (1 + cos tilt)/2, a uniform ground the rest of pi.
TEST(PlaneQuadrature, UniformSkyAndGround) {
  for (const double tilt_deg : {0.0, 10.0, 45.0, 89.0, 90.0, 120.0, 180.0})
    for (const double azimuth_deg : {0.0, 75.0, 180.0, 300.0})
      for (const Direction sun : {Direction{0.0, 0.0}, Direction{40.0, 180.0}, Direction{92.0, 30.0}}) {
        const TiltedPlane plane{tilt_deg, azimuth_deg};
        const double cosine = std::cos(tilt_deg * kRadiansPerDegree);
        EXPECT_NEAR(integral(plane_quadrature(plane, PlanePart::sky, sun, 93.0), uniform),
                    0.5 * kPi * (1.0 + cosine), 3e-5)
            << tilt_deg << " " << azimuth_deg;
        EXPECT_NEAR(integral(plane_quadrature(plane, PlanePart::ground, sun, 93.0), uniform),
                    0.5 * kPi * (1.0 - cosine), 3e-5)
            << tilt_deg << " " << azimuth_deg;
      }
}

// Henyey and Greenstein's aureole over the hemisphere that the plane faces, the plane turned to the sun: 2 pi
// ∫ p(µ) µ dµ = 2 pi (1 - g²)/g² ((1 + g² - g)/(1 - g) - √(1 + g²)).
TEST(PlaneQuadrature, AureoleInFrontOfThePlane) {
  for (const double g : {0.7, 0.85, 0.95}) {
    const double b = 1.0 + g * g;
    const double exact = 2.0 * kPi * (1.0 - g * g) / (g * g) * ((b - g) / (1.0 - g) - std::sqrt(b));
    for (const Direction sun : {Direction{20.0, 0.0}, Direction{60.0, 200.0}, Direction{85.0, 100.0}}) {
      const double sum = both({sun.zenith_deg, sun.azimuth_deg}, sun, 90.0, [&](const RelativeView& view) {
        const double cosine =
            std::cos(angle_between({view.zenith_deg, view.relative_azimuth_deg}, {sun.zenith_deg, 0.0}));
        return (1.0 - g * g) / std::pow(b - 2.0 * g * cosine, 1.5);
      });
      EXPECT_NEAR(sum / exact, 1.0, g < 0.9 ? 1e-4 : 2e-3) << g << " " << sun.zenith_deg;
    }
  }
}

// The light of all planes' two sides: what comes from a direction falls on a plane and on the one that faces
// the other way as |cos i|. Of L = 1 + cos z: 2 pi, since ∫ cos z |cos i| dΩ is 0; of (1 + cos z)²: ∫ cos² z
// |cos i| dΩ = pi/2 (1 + cos² tilt).
TEST(PlaneQuadrature, TwoSidesOfAPlane) {
  for (const double tilt_deg : {15.0, 60.0, 90.0}) {
    const Direction sun{50.0, 120.0};
    const auto radiance = [](const RelativeView& view) {
      const double brightness = 1.0 + std::cos(view.zenith_deg * kRadiansPerDegree);
      return brightness * brightness;
    };
    const double sum =
        both({tilt_deg, 10.0}, sun, 90.0, radiance) + both({180.0 - tilt_deg, 190.0}, sun, 90.0, radiance);
    const double cosine = std::cos(tilt_deg * kRadiansPerDegree);
    EXPECT_NEAR(sum, 2.0 * kPi + 0.5 * kPi * (1.0 + cosine * cosine), 1e-4);
  }
}

SkyScene scene_at(double sun_zenith_deg, double altitude_km = 0.0) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {altitude_km};
  scene.turbidities = {{TurbidityKind::aod500, 0.2}};
  scene.suns = {{sun_zenith_deg, 180.0}};
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 100.0);
  return scene;
}

SunIrradiance on(const TiltedPlane& plane, const SkyScene& scene, bool diffuse = true) {
  SunIrradianceOptions options;
  options.diffuse = diffuse;
  options.plane = plane;
  return simulate_sun(test::context, scene, options, {});
}

TEST(TiltedPlane, FlatIsHorizontal) {
  const SunIrradiance sun = on({0.0, 0.0}, scene_at(60.0));
  for (std::size_t i = 0; i < sun.wavelengths.size(); ++i) {
    EXPECT_NEAR(sun.plane_direct[i] / sun.direct_normal[i], 0.5, 1e-12);
    EXPECT_NEAR(sun.plane_sky[i] / sun.diffuse_horizontal[i], 1.0, 1e-3);
    EXPECT_EQ(sun.plane_ground[i], 0.0);
  }
}

// Upside down on the ground it has what the ground reflects: albedo times all that falls on it. 0.5 %: where
// lines absorb, the ground is lit through the few terms of the columns, the beam of the sums through all of
// them.
TEST(TiltedPlane, UpsideDownSeesTheGround) {
  const SunIrradiance sun = on({180.0, 0.0}, scene_at(60.0));
  const std::vector<double> global = sun.global_horizontal();
  for (std::size_t i = 0; i < sun.wavelengths.size(); ++i) {
    EXPECT_EQ(sun.plane_direct[i], 0.0);
    EXPECT_EQ(sun.plane_sky[i], 0.0);
    EXPECT_NEAR(sun.plane_ground[i] / (0.2 * global[i]), 1.0, 5e-3);
  }
}

// A wall: the beam at its angle, half of the ground's light, and mirror images alike.
TEST(TiltedPlane, Walls) {
  const SkyScene scene = scene_at(60.0);
  const SunIrradiance south = on({90.0, 180.0}, scene);
  const SunIrradiance west = on({90.0, 270.0}, scene);
  const SunIrradiance east = on({90.0, 90.0}, scene);
  const SunIrradiance north = on({90.0, 0.0}, scene);
  EXPECT_EQ(west.plane_sky, east.plane_sky);
  for (std::size_t i = 0; i < south.wavelengths.size(); ++i) {
    EXPECT_NEAR(south.plane_direct[i] / south.direct_normal[i], std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(west.plane_direct[i] / west.direct_normal[i], 0.0, 1e-12);
    EXPECT_EQ(north.plane_direct[i], 0.0);
    EXPECT_GT(south.plane_sky[i], west.plane_sky[i]);
    EXPECT_GT(west.plane_sky[i], north.plane_sky[i]);
    EXPECT_NEAR(south.plane_ground[i] / (0.1 * south.global_horizontal()[i]), 1.0, 5e-3);
    EXPECT_NEAR(north.plane_ground[i] / south.plane_ground[i], 1.0, 1e-5);
  }
}

TEST(TiltedPlane, WithoutDiffuseLightTheBeamAlone) {
  const SunIrradiance sun = on({30.0, 180.0}, scene_at(60.0), false);
  EXPECT_NEAR(sun.plane_direct[0] / sun.direct_normal[0], std::cos(30.0 * kRadiansPerDegree), 1e-12);
  EXPECT_TRUE(sun.plane_sky.empty());
  EXPECT_TRUE(sun.plane_ground.empty());
  EXPECT_TRUE(sun.plane_global().empty());
}

}  // namespace
}  // namespace skylut
