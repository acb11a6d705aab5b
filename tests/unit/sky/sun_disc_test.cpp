#include "skylut/sky/sun_disc.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/sky/sun_irradiance.hpp"
#include "support/test_atmosphere.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

SkyScene scene_at(double sun_zenith_deg, double altitude_km = 0.0) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {altitude_km};
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  scene.suns = {{sun_zenith_deg, 120.0}};
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 100.0);
  return scene;
}

// What simulate_sun says, which takes the sun for a point.
std::vector<double> beam(const SkyScene& scene) {
  return simulate_sun(test::context, scene, {false, 0.0}, {}).direct_normal;
}

// ∫ L dω in coordinates of the horizon, which know nothing of the disc's own: rows of equal zenith angle,
// their ends found from the cosine of the disc's radius.
std::vector<double> integral(const SunDisc& disc, double horizon_deg) {
  const double radius = disc.angular_radius_deg() * kRadiansPerDegree;
  const double sun = disc.sun().zenith_deg * kRadiansPerDegree;
  const double lowest = std::min(sun + radius, horizon_deg * kRadiansPerDegree);
  // z = middle + half sin t crowds the rows where the chords vanish.
  const Quadrature rows = gauss_legendre(200, -0.5 * kPi, std::asin(std::min(1.0, (lowest - sun) / radius)));
  const Quadrature along = gauss_legendre(60, -0.5 * kPi, 0.5 * kPi);
  std::vector<double> sum(disc.wavelengths().size(), 0.0);
  std::vector<float> radiance(sum.size());
  for (std::size_t r = 0; r < rows.node.size(); ++r) {
    const double z = sun + radius * std::sin(rows.node[r]);
    const double dz = radius * std::cos(rows.node[r]) * rows.weight[r];
    const double cosine = (std::cos(radius) - std::cos(z) * std::cos(sun)) / (std::sin(z) * std::sin(sun));
    const double half = std::acos(std::min(1.0, cosine));
    for (std::size_t k = 0; k < along.node.size(); ++k) {
      const Direction direction{z * kDegreesPerRadian,
                                disc.sun().azimuth_deg + half * std::sin(along.node[k]) * kDegreesPerRadian};
      disc.radiance({&direction, 1}, radiance);
      const double solid_angle = std::sin(z) * dz * half * std::cos(along.node[k]) * along.weight[k];
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += solid_angle * static_cast<double>(radiance[i]);
    }
  }
  return sum;
}

TEST(SunDisc, SizeOfTheSun) {
  EXPECT_NEAR(sun_angular_radius_deg(1.0) * 3600.0, 959.63, 1e-9);
  // Of the Astronomical Almanac's perihelion and aphelion: 16'15.9" and 15'43.9".
  EXPECT_NEAR(sun_angular_radius_deg(0.98331) * 3600.0, 16 * 60 + 15.9, 0.1);
  EXPECT_NEAR(sun_angular_radius_deg(1.01672) * 3600.0, 15 * 60 + 43.9, 0.1);
  EXPECT_NEAR(sun_solid_angle_sr(1.0), kPi * std::pow(959.63 / 3600.0 * kRadiansPerDegree, 2), 2e-10);
}

// The disc's own sum against one in other coordinates, through its radiances: 32-bit, hence 1e-6.
TEST(SunDisc, RadianceIntegratesToItsIrradiance) {
  for (const double sun_deg : {30.0, 60.0, 85.0, 89.0, 89.9, 90.0, 90.2}) {
    const SunDisc disc(test::context, scene_at(sun_deg));
    const std::vector<double> sum = integral(disc, 90.0);
    for (std::size_t i = 0; i < sum.size(); ++i)
      EXPECT_NEAR(sum[i] / disc.direct_normal()[i], 1.0, sun_deg <= 60.0 ? 1e-6 : 1e-5) << sun_deg;
  }
}

// Its irradiance is the beam's where the air's transmittance is straight over half a degree.
TEST(SunDisc, IrradianceOfTheBeam) {
  const auto difference = [](double sun_deg, double altitude_km) {
    const SkyScene scene = scene_at(sun_deg, altitude_km);
    const SunDisc disc(test::context, scene);
    double worst = 0.0;
    for (std::size_t i = 0; i < scene.wavelengths.size(); ++i)
      worst = std::max(worst, std::abs(disc.direct_normal()[i] / beam(scene)[i] - 1.0));
    return worst;
  };
  for (const double sun_deg : {0.0, 0.1, 45.0, 60.0}) EXPECT_LT(difference(sun_deg, 0.0), 2e-5) << sun_deg;
  EXPECT_LT(difference(85.0, 0.0), 4e-3);
  EXPECT_LT(difference(90.0, 30.0), 2e-3);
}

// Half of the sun at the horizon: half of its light above the air. Through it, the half that shines has less
// air before it than the centre.
TEST(SunDisc, HalfAtTheHorizon) {
  const SkyScene scene = scene_at(90.0);
  const SunDisc disc(test::context, scene);
  EXPECT_NEAR(disc.visible_solid_angle_sr(), 0.5 * sun_solid_angle_sr(1.0), 1e-12);
  const std::vector<double> point = beam(scene);
  const std::vector<double> higher = beam(scene_at(90.0 - disc.angular_radius_deg()));
  for (std::size_t i = 0; i < point.size(); ++i) {
    EXPECT_GT(disc.direct_normal()[i], 0.5 * point[i]);
    EXPECT_LT(disc.direct_normal()[i], 0.5 * higher[i]);
  }
}

TEST(SunDisc, SetsAndIsGone) {
  const SunDisc last(test::context, scene_at(90.26));
  EXPECT_GT(last.direct_normal().back(), 0.0);
  EXPECT_LT(last.visible_solid_angle_sr(), 0.01 * sun_solid_angle_sr(1.0));
  const SunDisc gone(test::context, scene_at(90.27));
  EXPECT_EQ(gone.direct_normal().back(), 0.0);
  EXPECT_EQ(gone.visible_solid_angle_sr(), 0.0);
  EXPECT_TRUE(gone.points(0.1).directions.empty());
  EXPECT_EQ(gone.illuminance(), Xyz{});
  // From 12 km the horizon dips 3.51 deg.
  EXPECT_GT(SunDisc(test::context, scene_at(93.7, 12.0)).visible_solid_angle_sr(), 0.0);
  EXPECT_EQ(SunDisc(test::context, scene_at(93.8, 12.0)).visible_solid_angle_sr(), 0.0);
}

TEST(SunDisc, RadianceEndsAtTheLimbAndAtTheHorizon) {
  const SunDisc disc(test::context, scene_at(89.9));
  const auto luminance = [&](const Direction& direction) {
    Xyz colour;
    disc.colour({&direction, 1}, {&colour, 1});
    return colour.Y;
  };
  const double radius_deg = disc.angular_radius_deg();
  EXPECT_GT(luminance({89.9, 120.0}), 0.0);
  EXPECT_GT(luminance({89.9, 120.0 + 0.999 * radius_deg}), 0.0);
  EXPECT_EQ(luminance({89.9, 120.0 + 1.001 * radius_deg}), 0.0);
  EXPECT_EQ(luminance({89.9 - 1.001 * radius_deg, 120.0}), 0.0);
  EXPECT_GT(luminance({90.0, 120.0}), 0.0);
  EXPECT_EQ(luminance({90.0001, 120.0}), 0.0);
  // Reddened below: the upper limb is as dark as the lower one above the air.
  EXPECT_GT(luminance({89.9 - 0.05, 120.0}), luminance({89.9 + 0.05, 120.0}));
}

// 7.5 arcsec between the nodes of the transmittance: against the beam of every direction itself. From a
// height the lower limb shines through the troposphere along the horizon, with 1e-6 of the upper one's light;
// the kinks where a ray touches one layer more are blurred there.
TEST(SunDisc, TransmittanceBetweenItsNodes) {
  const LimbDarkening darkening = LimbDarkening::load(test::context);
  for (const double altitude_km : {0.0, 12.0, 30.0}) {
    const double centre_deg = 90.0 + std::acos(6371.0 / (6371.0 + altitude_km)) * kDegreesPerRadian - 0.2;
    SkyScene scene = scene_at(centre_deg, altitude_km);
    const SunDisc disc(test::context, scene);
    const double top_deg = centre_deg - 0.99 * disc.angular_radius_deg();
    const std::size_t count = scene.wavelengths.size();
    std::vector<float> here(count);
    for (int n = 0; n < 23; ++n) {
      const Direction direction{top_deg + n * 0.02, 120.0};
      disc.radiance({&direction, 1}, here);
      scene.suns = {direction};
      const std::vector<double> point = beam(scene);
      const double r = std::abs(direction.zenith_deg - centre_deg) / disc.angular_radius_deg();
      for (std::size_t i = 0; i < count; ++i) {
        const double expected =
            point[i] / sun_solid_angle_sr(1.0) * darkening.at(scene.wavelengths[i])(std::sqrt(1.0 - r * r));
        const double difference = static_cast<double>(here[i]) - expected;
        EXPECT_LT(std::abs(difference), (altitude_km == 0.0 ? 1e-4 : 0.02) * expected)
            << altitude_km << " km, " << direction.zenith_deg << " deg, " << scene.wavelengths[i] << " nm";
      }
    }
  }
}

TEST(SunDisc, PointsHoldAllItsLightAtAnySpacing) {
  for (const double sun_deg : {0.0, 60.0, 89.9}) {
    const SunDisc disc(test::context, scene_at(sun_deg));
    for (const double spacing_deg : {1.0, 0.1, 0.01}) {
      const SunDiscPoints points = disc.points(spacing_deg);
      std::vector<double> sum(disc.wavelengths().size(), 0.0);
      double illuminance = 0.0;
      for (std::size_t p = 0; p < points.directions.size(); ++p) {
        EXPECT_LE(angle_between(points.directions[p], disc.sun()),
                  disc.angular_radius_deg() * kRadiansPerDegree * (1.0 + 1e-9));
        EXPECT_LE(points.directions[p].zenith_deg, 90.0 + 1e-9);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += points.irradiance[p * sum.size() + i];
        illuminance += points.illuminance[p].Y;
      }
      for (std::size_t i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(sum[i] / disc.direct_normal()[i], 1.0, 1e-12) << spacing_deg;
      EXPECT_NEAR(illuminance / disc.illuminance().Y, 1.0, 1e-12);
    }
  }
}

// No direction of the disc is further from a point than the spacing.
TEST(SunDisc, PointsLeaveNoGap) {
  const SunDisc disc(test::context, scene_at(50.0));
  const SunDiscPoints points = disc.points(0.05);
  for (int step = 0; step < 500; ++step) {
    const double r = disc.angular_radius_deg() * std::sqrt((step + 0.5) / 500.0);
    const double turn = 2.399963 * step;  // the golden angle
    const Direction direction{50.0 + r * std::cos(turn),
                              120.0 + r * std::sin(turn) / std::sin(50.0 * kRadiansPerDegree)};
    double nearest = 1.0;
    for (const Direction& point : points.directions)
      nearest = std::min(nearest, angle_between(point, direction));
    EXPECT_LT(nearest * kDegreesPerRadian, 0.05 / std::sqrt(2.0));
  }
}

TEST(SunDisc, NearAndFar) {
  SkyScene scene = scene_at(60.0);
  const SunDisc mean(test::context, scene);
  scene.sun_distance_au = 1.0167;
  const SunDisc far(test::context, scene);
  EXPECT_NEAR(mean.angular_radius_deg() / far.angular_radius_deg(), 1.0167, 1e-6);
  EXPECT_NEAR(mean.direct_normal()[0] / far.direct_normal()[0], 1.0167 * 1.0167, 1e-5);
  std::vector<float> a(4);
  std::vector<float> b(4);
  mean.radiance({&scene.suns[0], 1}, a);
  far.radiance({&scene.suns[0], 1}, b);
  EXPECT_NEAR(a[1] / b[1], 1.0f, 1e-6f);
}

// 133.1 klx over 6.80e-5 sr is 1.957e9 cd/m2 above the air; the ozone above 30 km takes 0.7 % of it.
TEST(SunDisc, LuminanceAboveTheAir) {
  SkyScene scene = scene_at(0.0, 30.0);
  scene.turbidities = {{TurbidityKind::aod500, 0.0}};
  scene.wavelengths = WavelengthGrid::visible();
  const SunDisc disc(test::context, scene);
  EXPECT_NEAR(disc.illuminance().Y / disc.visible_solid_angle_sr(), 1.957e9 * 0.993, 0.005e9);
}

TEST(SunDisc, RefusesWhatItCannotDo) {
  EXPECT_THROW(SunDisc(test::context, scene_at(181.0)), InputError);
  EXPECT_THROW(SunDisc(test::context, scene_at(45.0, 31.0)), InputError);
  SkyScene two = scene_at(45.0);
  two.suns.push_back({30.0, 0.0});
  EXPECT_THROW(SunDisc(test::context, two), InputError);
  const SunDisc disc(test::context, scene_at(45.0));
  for (const double spacing_deg : {0.0, 0.001, 1.5, -1.0, std::nan("")})
    EXPECT_THROW(disc.points(spacing_deg), InputError);
}

}  // namespace
}  // namespace skylut
