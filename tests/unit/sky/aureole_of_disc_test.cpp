#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scattering_factors.hpp"
#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/sky/continuous_sky.hpp"
#include "skylut/sky/solved_sky.hpp"
#include "skylut/sky/sun_disc.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

constexpr Direction kSun{40.0, 100.0};

// Dust: large particles, whose forward peak is not much wider than the disc.
SkyScene scene() {
  AtmosphereDescription air;
  air.aerosol = "desert";
  static const auto atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(test::context, air));
  SkyScene scene;
  scene.atmosphere = atmosphere;
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.3}};
  scene.suns = {kSun};
  scene.wavelengths = WavelengthGrid(450.0, 650.0, 100.0);
  return scene;
}

std::vector<float> at(const ScatteringFactors& factors, double angle_deg, std::size_t wavelengths) {
  std::vector<float> values(factors.parts().size() * wavelengths);
  factors.spectral(std::cos(angle_deg * kRadiansPerDegree), values);
  return values;
}

// Means over a disc in its own light, which SunDisc's points hold without air (the airless disc's weights are
// those of its limb darkening), by an independent sum.
TEST(AureoleOfTheDisc, FactorsAreMeansOverTheDisc) {
  const SkyScene air = scene();
  const std::size_t wavelengths = air.wavelengths.size();
  const SolvedSky sky(test::context, air, {}, SunShape::disc);
  SkyScene overhead = air;
  overhead.altitudes_km = {30.0};  // next to no air: the points' light is the disc's own
  overhead.suns = {{40.0, 180.0}};
  const SunDiscPoints points = SunDisc(test::context, overhead).points(0.01);
  for (const double angle_deg : {0.0, 0.1, 0.266, 0.4, 1.0, 3.0}) {
    const Direction view{40.0 - angle_deg, 180.0};
    std::vector<double> mean(sky.factors().parts().size() * wavelengths);
    std::vector<double> all(wavelengths);
    for (std::size_t p = 0; p < points.directions.size(); ++p) {
      const double angle = angle_between(view, points.directions[p]) * kDegreesPerRadian;
      const std::vector<float> factors = at(sky.factors_of_point(), angle, wavelengths);
      for (std::size_t i = 0; i < wavelengths; ++i) all[i] += points.irradiance[p * wavelengths + i];
      for (std::size_t i = 0; i < mean.size(); ++i)
        mean[i] += points.irradiance[p * wavelengths + i % wavelengths] * static_cast<double>(factors[i]);
    }
    const std::vector<float> found = at(sky.factors(), angle_deg, wavelengths);
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const double expected = mean[i] / all[i % wavelengths];
      EXPECT_NEAR(static_cast<double>(found[i]), expected, 2e-4 * std::abs(expected) + 1e-6)
          << angle_deg << " deg, factor " << i;
    }
  }
}

// Every point of the disc lights a sky of its own; seen from the middle of the disc, or beside it, their mean
// is what the point's sky looks like around the mirrored point. A, B, C and D are smooth: second differences
// over half a degree are next to nothing.
TEST(AureoleOfTheDisc, IsTheMeanOfThePointsSkies) {
  const SkyScene air = scene();
  const auto point = std::make_shared<const SolvedSky>(test::context, air, TransferOptions{});
  const auto disc = std::make_shared<const SolvedSky>(test::context, air, TransferOptions{}, SunShape::disc);
  const ContinuousSky of_point(test::context, point, 0.0, kSun);
  const ContinuousSky of_disc(test::context, disc, 0.0, kSun);
  // It is compared with the point's lines of sight: the same patches.
  EXPECT_EQ(of_point.nodes(), of_disc.nodes());
  EXPECT_EQ(of_point.error(), of_disc.error());

  SkyScene overhead = air;
  overhead.altitudes_km = {30.0};
  const SunDiscPoints points = SunDisc(test::context, overhead).points(0.02);
  std::vector<float> radiance(3);
  std::vector<float> found(3);
  for (const double beside_deg : {0.0, 0.25, 1.0}) {
    const Direction view{kSun.zenith_deg, kSun.azimuth_deg + beside_deg};
    std::vector<double> mean(3);
    std::vector<double> all(3);
    for (std::size_t p = 0; p < points.directions.size(); ++p) {
      const Direction moved{view.zenith_deg + points.directions[p].zenith_deg - kSun.zenith_deg,
                            view.azimuth_deg + points.directions[p].azimuth_deg - kSun.azimuth_deg};
      of_point.radiance({&moved, 1}, radiance);
      for (std::size_t i = 0; i < 3; ++i) {
        mean[i] += points.irradiance[3 * p + i] * static_cast<double>(radiance[i]);
        all[i] += points.irradiance[3 * p + i];
      }
    }
    of_disc.radiance({&view, 1}, found);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(static_cast<double>(found[i]) * all[i] / mean[i], 1.0, 3e-4) << beside_deg << " " << i;
  }
  // Far from the sun nothing changes; colours and spectra agree.
  const std::vector<Direction> views{kSun, {60.0, 280.0}};
  std::vector<float> a(6);
  std::vector<float> b(6);
  of_point.radiance(views, a);
  of_disc.radiance(views, b);
  for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(a[i], b[i]);
  std::vector<Xyz> colour(2);
  of_disc.colour(views, colour);
  for (std::size_t v = 0; v < 2; ++v) {
    double luminance = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      luminance += disc->colour_weights()[i].Y * static_cast<double>(b[3 * v + i]);
    EXPECT_NEAR(colour[v].Y / luminance, 1.0, 2e-4);
  }
}

}  // namespace
}  // namespace skylut
