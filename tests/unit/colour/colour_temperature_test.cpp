#include "skylut/colour/colour_temperature.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/test_context.hpp"

namespace skylut {
namespace {

PlanckianLocus locus() { return PlanckianLocus(ColourMatching::load(test::context)); }

double temperature_K(double x, double y) { return locus().nearest({1.0, x, y})->temperature_K; }

// McCamy 1992, Color Research & Application 17, 142, doi:10.1002/col.5080170211: a cubic, some 10 K off
// at 3500 K.
double mccamy_K(double x, double y) {
  const double n = (x - 0.3320) / (0.1858 - y);
  return ((449.0 * n + 3525.0) * n + 6823.3) * n + 5520.33;
}

// CIE 15:2004: chromaticities of the illuminants and their temperatures; daylight was
// named with c2 = 0.01438 m K, so that D65 is 6504 K and D50 5003 K with today's. A is 2856 K.
TEST(ColourTemperature, PublishedIlluminants) {
  EXPECT_NEAR(temperature_K(0.31272, 0.32903), 6504.0, 2.0);
  EXPECT_NEAR(temperature_K(0.34567, 0.35851), 5003.0, 2.0);
  EXPECT_NEAR(temperature_K(0.33243, 0.34744), 5503.0, 2.0);
  EXPECT_NEAR(temperature_K(0.29903, 0.31488), 7504.0, 3.0);
  EXPECT_NEAR(temperature_K(0.44758, 0.40745), 2856.0, 1.0);
}

// Daylight lies above the locus by 0.003, illuminant A on it (Ohno 2014, Leukos 10, 47).
TEST(ColourTemperature, DistanceFromTheLocus) {
  EXPECT_NEAR(locus().nearest({1.0, 0.31272, 0.32903})->duv, 0.0032, 1e-4);
  EXPECT_NEAR(locus().nearest({1.0, 0.44758, 0.40745})->duv, 0.0, 2e-5);
  EXPECT_LT(locus().nearest({1.0, 0.31272, 0.31})->duv, 0.0);
}

TEST(ColourTemperature, OfBlackBodiesIsTheirTemperature) {
  for (const double temperature : {1010.0, 1800.0, 2856.0, 5000.0, 6504.0, 12000.0, 25000.0, 80000.0}) {
    const auto found = locus().nearest(locus().chromaticity(temperature));
    ASSERT_TRUE(found) << temperature;
    EXPECT_NEAR(found->temperature_K / temperature, 1.0, 2e-6);
    EXPECT_NEAR(found->duv, 0.0, 1e-7);
  }
}

TEST(ColourTemperature, AgreesWithMcCamysCubic) {
  for (double temperature = 2900.0; temperature <= 6500.0; temperature += 300.0) {
    const Yxy body = locus().chromaticity(temperature);
    EXPECT_NEAR(mccamy_K(body.x, body.y), temperature, 10.0) << temperature;
  }
}

TEST(ColourTemperature, NoneForWhatIsNoWhite) {
  EXPECT_FALSE(locus().nearest({1.0, 0.17, 0.01}));  // violet
  EXPECT_FALSE(locus().nearest({1.0, 0.30, 0.60}));  // green
  EXPECT_FALSE(locus().nearest({1.0, 0.22, 0.22}));  // bluer than the hottest
  EXPECT_FALSE(locus().nearest({1.0, 0.68, 0.32}));  // redder than the coldest
}

}  // namespace
}  // namespace skylut
