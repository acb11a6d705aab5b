#include "skylut/sky/dome_sky.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

const std::vector<double> kSuns_deg{0.0, 55.0, 86.0, 90.0, 93.0};

std::shared_ptr<const SolvedSky> solved(double aod500) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.turbidities = {{TurbidityKind::aod500, aod500}};
  for (const double sun_deg : kSuns_deg) scene.suns.push_back({sun_deg, 0.0});
  scene.wavelengths = WavelengthGrid(450.0, 650.0, 100.0);
  TransferOptions options;
  options.discretisation = discretisation_of(Quality::draft);
  options.discretisation.sun_bands = false;
  return std::make_shared<const SolvedSky>(test::context, scene, options);
}

/// Directions of the dome off any grid (the golden angle's spiral), many close to the horizon and the sun.
std::vector<Direction> everywhere(double sun_deg) {
  std::vector<Direction> directions{{0.0, 0.0}, {90.0, 0.0}, {90.0, 180.0}};
  for (int i = 0; i < 40; ++i) {
    const double azimuth_deg = std::fmod(137.50776 * i, 360.0);
    directions.push_back({std::acos(1.0 - (i + 0.5) / 40.0) * kDegreesPerRadian, azimuth_deg});
    directions.push_back({90.0 - 6.0 * i * i / 1600.0, azimuth_deg});
    directions.push_back({std::min(90.0, std::abs(sun_deg + 3.0 * std::cos(i))), 3.0 * std::sin(i)});
  }
  return directions;
}

std::vector<Xyz> colours(const SkyLight& sky, const std::vector<Direction>& directions) {
  std::vector<Xyz> found(directions.size());
  sky.colour(directions, found);
  return found;
}

// To 0.3 % with the sun up, a wavelength to twice that. In twilight the Earth's shadow has an edge: luminance
// to 2 % in the mean, and to 20 % where clean air is darkest.
TEST(DomeSky, IsTheSkyOfLinesOfSight) {
  for (const double aod500 : {0.0, 0.3}) {
    const auto sky = solved(aod500);
    for (const double altitude_km : {0.0, 7.3})
      for (const DomeSky& dome : DomeSky::under_suns(test::context, sky, altitude_km, kSuns_deg)) {
        const double sun_deg = dome.sun().zenith_deg;
        const bool up = sun_deg <= 90.0;
        const double bar = up ? 3e-3 : 0.2;
        double squares = 0.0;
        const std::vector<Direction> directions = everywhere(sun_deg);
        const std::vector<Xyz> found = colours(dome, directions);
        const std::vector<Xyz> expected = colours(dome.exact(), directions);
        std::vector<float> spectra(3 * directions.size());
        std::vector<float> expected_spectra(3 * directions.size());
        dome.radiance(directions, spectra);
        dome.exact().radiance(directions, expected_spectra);
        for (std::size_t i = 0; i < directions.size(); ++i) {
          const auto where = [&] {
            return fmt::format("aod500 {}, {} km, sun {}, view {}:{}", aod500, altitude_km, sun_deg,
                               directions[i].zenith_deg, directions[i].azimuth_deg);
          };
          EXPECT_NEAR(found[i].X / expected[i].X, 1.0, bar) << where();
          EXPECT_NEAR(found[i].Y / expected[i].Y, 1.0, bar) << where();
          EXPECT_NEAR(found[i].Z / expected[i].Z, 1.0, bar) << where();
          for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
            EXPECT_NEAR(spectra[k] / expected_spectra[k], 1.0f, up ? 6e-3f : 0.5f) << where();
          squares += std::pow(found[i].Y / expected[i].Y - 1.0, 2.0);
        }
        EXPECT_LT(std::sqrt(squares / static_cast<double>(directions.size())), up ? 1e-3 : 2e-2) << sun_deg;
      }
  }
}

// Between 90° and the horizon, where the sun's aureole is at its brightest: against lines of sight crowded
// around it.
TEST(DomeSky, LuminanceBelow90) {
  const auto sky = solved(0.3);
  EXPECT_EQ(DomeSky::under_suns(test::context, sky, 0.0, {{90.0}}).front().luminance_below(), 0.0);
  for (const double altitude_km : {0.7, 7.3, 30.0})
    for (const DomeSky& dome : DomeSky::under_suns(test::context, sky, altitude_km, kSuns_deg)) {
      const Quadrature zeniths = gauss_legendre(24, 90.0, dome.horizon_zenith_deg());
      constexpr int kSteps = 60;
      std::vector<Direction> directions;
      std::vector<double> weights;
      for (std::size_t i = 0; i < zeniths.node.size(); ++i)
        for (int k = 0; k < kSteps; ++k) {
          const double t = (k + 0.5) / kSteps;
          directions.push_back({zeniths.node[i], 180.0 * t * t * t});
          weights.push_back(zeniths.weight[i] * std::sin(zeniths.node[i] * kRadiansPerDegree) * t * t);
        }
      double sum = 0.0;
      double all = 0.0;
      const std::vector<Xyz> exact = colours(dome.exact(), directions);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        sum += weights[i] * exact[i].Y;
        all += weights[i];
      }
      EXPECT_NEAR(dome.luminance_below() / (sum / all), 1.0, 0.02)
          << altitude_km << " km, sun " << dome.sun().zenith_deg;
    }
}

// A sky is its own, whatever the suns beside it and the number of threads; beyond 90° it is its lines of
// sight.
TEST(DomeSky, DependsOnNothingElse) {
  const auto sky = solved(0.3);
  const std::vector<Direction> directions{
      {20.0, 50.0}, {89.0, 10.0}, {91.0, 10.0}, {91.0, 60.0}, {88.0, 0.0}};
  const std::vector<DomeSky> all = DomeSky::under_suns(test::on_threads(2), sky, 7.3, kSuns_deg);
  for (std::size_t i = 0; i < kSuns_deg.size(); ++i) {
    const std::vector<Xyz> found = colours(all[i], directions);
    const auto alone = DomeSky::under_suns(test::on_threads(1), sky, 7.3, {{kSuns_deg[i]}});
    EXPECT_EQ(found, colours(alone.front(), directions));
    EXPECT_EQ(all[i].luminance_below(), alone.front().luminance_below());
    const std::vector<Xyz> exact = colours(all[i].exact(), directions);
    EXPECT_EQ(found[2], exact[2]);
    EXPECT_EQ(found[3], exact[3]);
  }
}

TEST(DomeSky, IsFainterFarFromTheSun) {
  const auto sky = solved(0.3);
  const std::vector<Direction> directions{{20.0, 50.0}, {91.0, 10.0}};
  const auto near = DomeSky::under_suns(test::context, sky, 7.3, {{55.0}});
  const auto far = DomeSky::under_suns(test::context, sky, 7.3, {{55.0}}, 2.0);
  for (std::size_t i = 0; i < directions.size(); ++i)
    EXPECT_NEAR(colours(far.front(), directions)[i].Y / colours(near.front(), directions)[i].Y, 0.25, 1e-6);
  EXPECT_NEAR(far.front().luminance_below() / near.front().luminance_below(), 0.25, 1e-9);
}

TEST(DomeSky, RefusesWhatItCannotShow) {
  const auto sky = solved(0.0);
  EXPECT_THROW(DomeSky::under_suns(test::context, sky, 31.0, {{55.0}}), InputError);
  EXPECT_THROW(DomeSky::under_suns(test::context, sky, 1.0, {{97.0}}), InputError);
  EXPECT_THROW(DomeSky::under_suns(test::context, sky, 1.0, {{55.0}}, 0.0), InputError);
}

}  // namespace
}  // namespace skylut
