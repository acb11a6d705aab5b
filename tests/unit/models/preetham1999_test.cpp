#include "skylut/models/preetham1999.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

SkyConditions with(double T, const Direction& sun) {
  return {.turbidity = {TurbidityKind::preetham_t, T}, .sun = sun};
}

std::unique_ptr<const Sky> sky(double T, const Direction& sun) { return Preetham1999().at(with(T, sun)); }

// By hand: T = 2, sun 45°: χ = (4/9 - 1/60) π/2 = 0.671952, Y_z = 3.1196 tan χ + 1.9882.
TEST(Preetham1999, ZenithByHand) {
  const Yxy zenith = preetham1999_zenith_kcd_m2(2.0, kPi / 4.0);
  EXPECT_NEAR(zenith.Y, 3.1196 * std::tan((4.0 / 9.0 - 1.0 / 60.0) * kPi / 2.0) + 1.9882, 1e-12);
  EXPECT_NEAR(zenith.Y, 4.47, 0.01);
  // x_z, rows collected for T = 2: 0.0657 θ³ - 0.0992 θ² + 0.0049 θ + 0.2667.
  const double t = kPi / 4.0;
  EXPECT_NEAR(zenith.x, 0.0657 * t * t * t - 0.0992 * t * t + 0.0049 * t + 0.2667, 1e-12);
  // y_z: 0.0805 θ³ - 0.1126 θ² - 0.0035 θ + 0.2773.
  EXPECT_NEAR(zenith.y, 0.0805 * t * t * t - 0.1126 * t * t - 0.0035 * t + 0.2773, 1e-12);
}

TEST(Preetham1999, CoefficientsAtTwo) {
  const PerezYxy k = preetham1999_coefficients(2.0);
  EXPECT_NEAR(k.Y.A, -1.1056, 1e-12);
  EXPECT_NEAR(k.Y.B, -0.2833, 1e-12);
  EXPECT_NEAR(k.Y.C, 5.2797, 1e-12);
  EXPECT_NEAR(k.Y.D, -2.3359, 1e-12);
  EXPECT_NEAR(k.Y.E, 0.2363, 1e-12);
  // The signs that the UTM report loses.
  EXPECT_NEAR(k.x.A, -0.2978, 1e-12);
  EXPECT_NEAR(k.x.D, -1.0271, 1e-12);
  EXPECT_NEAR(k.y.D, -1.7419, 1e-12);
}

TEST(Preetham1999, TheZenithOfTheSkyIsTheZenithFormula) {
  for (const double T : {2.0, 4.0, 6.0})
    for (const double sun_zenith : {0.0, 30.0, 75.0, 90.0}) {
      const Yxy above = sky(T, {sun_zenith, 123.0})->colour(Direction{0.0, 0.0});
      const Yxy zenith = preetham1999_zenith_kcd_m2(T, sun_zenith * kRadiansPerDegree);
      EXPECT_NEAR(above.Y, 1000.0 * zenith.Y, 1e-9);
      EXPECT_NEAR(above.x, zenith.x, 1e-12);
      EXPECT_NEAR(above.y, zenith.y, 1e-12);
    }
}

TEST(Preetham1999, IsBrightAndWhiterNearTheSun) {
  const auto model = sky(3.0, {45.0, 90.0});
  const std::vector<Direction> views{{45.0, 95.0}, {45.0, 270.0}};
  std::vector<Yxy> colours(2);
  model->colour(views, colours);
  EXPECT_GT(colours[0].Y, 3.0 * colours[1].Y);
  EXPECT_GT(colours[0].x, colours[1].x);
}

TEST(Preetham1999, RefusesWhatItIsNotDefinedFor) {
  const Direction sun{45.0, 0.0};
  EXPECT_THROW(sky(0.9, sun), InputError);
  EXPECT_THROW(sky(std::nan(""), sun), InputError);
  EXPECT_THROW(sky(2.0, {91.0, 0.0}), InputError);
  EXPECT_THROW(sky(2.0, sun)->colour(Direction{91.0, 0.0}), InputError);
  EXPECT_THROW(sky(1.2, sun)->colour(Direction{90.0, 0.0}), InputError);
  EXPECT_NO_THROW(sky(1.21, sun)->colour(Direction{90.0, 0.0}));
  SkyConditions conditions = with(3.0, sun);
  conditions.altitude_km = 6.0;
  EXPECT_THROW(Preetham1999().at(conditions), InputError);
  conditions = with(3.0, sun);
  conditions.turbidity.kind = TurbidityKind::aod500;
  EXPECT_THROW(Preetham1999().at(conditions), InputError);
}

}  // namespace
}  // namespace skylut
