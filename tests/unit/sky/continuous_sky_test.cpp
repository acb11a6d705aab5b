#include "skylut/sky/continuous_sky.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/sky/exact_sky.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

SkyScene scene(double aod500, std::vector<Direction> suns) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.turbidities = {{TurbidityKind::aod500, aod500}};
  scene.suns = std::move(suns);
  scene.wavelengths = WavelengthGrid(450.0, 650.0, 100.0);
  return scene;
}

std::shared_ptr<const SolvedSky> solved(double aod500, std::vector<Direction> suns) {
  return std::make_shared<const SolvedSky>(test::context, scene(aod500, std::move(suns)), TransferOptions{});
}

/// Directions of the whole sphere off any grid (the golden angle's spiral), some close to the horizon and to
/// the sun.
std::vector<Direction> everywhere(double horizon_deg, const Direction& sun) {
  std::vector<Direction> directions;
  for (int i = 0; i < 60; ++i) {
    const double azimuth_deg = std::fmod(137.50776 * i, 360.0);
    directions.push_back({std::acos(1.0 - (2.0 * i + 1.0) / 60.0) * kDegreesPerRadian, azimuth_deg});
    const double offset_deg = (i % 2 == 0 ? 1.0 : -1.0) * (0.01 + 4.0 * i * i / 3600.0);
    directions.push_back({horizon_deg + offset_deg, azimuth_deg});
    directions.push_back({std::abs(sun.zenith_deg + 5.0 * std::cos(i)), sun.azimuth_deg + 5.0 * std::sin(i)});
  }
  return directions;
}

// Against lines of sight everywhere on the sphere: luminance to 0.3 % on the ground, 0.5 % aloft, 1 % in
// twilight; a wavelength to twice that.
TEST(ContinuousSky, IsTheSkyOfLinesOfSight) {
  for (const double aod500 : {0.0, 0.3}) {
    const std::vector<Direction> suns{{0.0, 0.0}, {55.0, 100.0}, {88.0, 100.0}, {92.0, 100.0}};
    const auto sky = solved(aod500, suns);
    for (const double altitude_km : {0.0, 7.3})
      for (const Direction& sun : suns) {
        const ContinuousSky continuous(test::context, sky, altitude_km, sun);
        const ExactSky exact(sky, altitude_km, sun);
        const double bar = sun.zenith_deg > 90.0 ? 1e-2 : altitude_km > 0.0 ? 5e-3 : 3e-3;
        const std::vector<Direction> directions = everywhere(exact.horizon_zenith_deg(), sun);
        std::vector<Xyz> found(directions.size());
        std::vector<Xyz> expected(directions.size());
        continuous.colour(directions, found);
        exact.colour(directions, expected);
        std::vector<float> spectra(3 * directions.size());
        std::vector<float> expected_spectra(3 * directions.size());
        continuous.radiance(directions, spectra);
        exact.radiance(directions, expected_spectra);
        for (std::size_t i = 0; i < directions.size(); ++i) {
          const auto where = [&] {
            return fmt::format("aod500 {}, {} km, sun {}, view {}:{}", aod500, altitude_km, sun.zenith_deg,
                               directions[i].zenith_deg, directions[i].azimuth_deg);
          };
          EXPECT_NEAR(found[i].Y / expected[i].Y, 1.0, bar) << where();
          EXPECT_NEAR(found[i].X / expected[i].X, 1.0, 1.5 * bar) << where();
          EXPECT_NEAR(found[i].Z / expected[i].Z, 1.0, 1.5 * bar) << where();
          for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
            EXPECT_NEAR(spectra[k] / expected_spectra[k], 1.0f, static_cast<float>(2.0 * bar)) << where();
        }
      }
  }
}

// It says how good it is, gets better when asked, and costs more then.
TEST(ContinuousSky, RefinesToItsTolerance) {
  const Direction sun{80.0, 0.0};
  const auto sky = solved(0.1, {sun});
  const ContinuousSky coarse(test::context, sky, 12.0, sun, 1.0, {.tolerance = 0.05});
  const ContinuousSky fine(test::context, sky, 12.0, sun, 1.0, {.tolerance = 5e-4});
  EXPECT_LE(coarse.error(), 0.05);
  EXPECT_LE(fine.error(), 5e-4);
  EXPECT_GT(fine.nodes(), coarse.nodes());
}

// Colour and spectrum are two roads to one luminance.
TEST(ContinuousSky, ColoursAreThoseOfItsSpectra) {
  const Direction sun{70.0, 45.0};
  const auto sky = solved(0.4, {sun});
  const ContinuousSky continuous(test::context, sky, 0.0, sun);
  const std::vector<Direction> directions = everywhere(90.0, sun);
  std::vector<Xyz> colours(directions.size());
  std::vector<float> spectra(3 * directions.size());
  continuous.colour(directions, colours);
  continuous.radiance(directions, spectra);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    double Y = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      Y += sky->colour_weights()[k].Y * static_cast<double>(spectra[3 * i + k]);
    EXPECT_NEAR(colours[i].Y / Y, 1.0, 2e-4) << directions[i].zenith_deg << " " << directions[i].azimuth_deg;
  }
}

// Left and right of the sun are mirror images, whatever its azimuth; a sun farther away is dimmer.
TEST(ContinuousSky, SymmetryAndDistance) {
  const Direction sun{60.0, 350.0};
  const auto sky = solved(0.2, {sun});
  const ContinuousSky near(test::context, sky, 0.0, sun);
  const ContinuousSky far(test::context, sky, 0.0, sun, 2.0);
  const std::vector<Direction> views{{40.0, 20.0}, {40.0, 320.0}};
  std::vector<Xyz> colours(2);
  near.colour(views, colours);
  EXPECT_NEAR(colours[0].Y / colours[1].Y, 1.0, 1e-6);
  std::vector<Xyz> dim(2);
  far.colour(views, dim);
  EXPECT_NEAR(4.0 * dim[0].Y / colours[0].Y, 1.0, 1e-12);
}

TEST(ContinuousSky, SameBytesOnAnyNumberOfThreads) {
  const Direction sun{89.0, 0.0};
  const auto sky = solved(0.1, {sun});
  const std::vector<Direction> directions = everywhere(92.0, sun);
  std::vector<float> one(3 * directions.size());
  std::vector<float> three(3 * directions.size());
  ContinuousSky(test::on_threads(1), sky, 6.0, sun).radiance(directions, one);
  ContinuousSky(test::on_threads(3), sky, 6.0, sun).radiance(directions, three);
  EXPECT_EQ(one, three);
}

TEST(ContinuousSky, RefusesWhatItWasNotSolvedFor) {
  const auto sky = solved(0.1, {{20.0, 0.0}});
  EXPECT_THROW(ContinuousSky(test::context, sky, 0.0, {90.0, 0.0}), InputError);  // no such sun was solved
  EXPECT_THROW(ContinuousSky(test::context, sky, 31.0, {20.0, 0.0}), InputError);
  EXPECT_THROW(ContinuousSky(test::context, sky, 0.0, {20.0, 0.0}, 0.0), InputError);
  EXPECT_THROW(ContinuousSky(test::context, sky, 0.0, {20.0, 0.0}, 1.0, {.tolerance = 0.0}), InputError);
}

}  // namespace
}  // namespace skylut
