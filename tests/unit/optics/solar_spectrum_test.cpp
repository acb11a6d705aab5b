#include "skylut/optics/solar_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

// ASTM G-173-03 itself has 734.8 W/m² between 360 and 830 nm; half bands at both ends cost 0.2.
TEST(SolarSpectrum, IntegralOfTheSource) {
  const SolarSpectrum sun = SolarSpectrum::load();
  EXPECT_NEAR(sun.integral_W_m2(360.0, 830.0), 734.8, 0.3);
  EXPECT_NEAR(sun.integral_W_m2(380.0, 780.0), 655.9, 0.3);
  EXPECT_NEAR(sun.integral_W_m2(297.5, 1002.5), 939.0, 0.05);
}

// SPCTRAL2 (Bird and Riordan 1986) has 1.891 at 530 nm and 1.728 at 610 nm: the maximum's flat side.
TEST(SolarSpectrum, GreenLight) {
  EXPECT_NEAR(SolarSpectrum::load().irradiance_W_m2_nm(555.0, 5.0), 1.88, 0.03);
}

TEST(SolarSpectrum, BandMeans) {
  const SolarSpectrum sun({500.0, 510.0, 520.0}, {1.0, 2.0, 4.0});
  EXPECT_DOUBLE_EQ(sun.irradiance_W_m2_nm(510.0, 10.0), 2.0);
  EXPECT_DOUBLE_EQ(sun.irradiance_W_m2_nm(505.0, 10.0), 1.5);  // half of each
  EXPECT_DOUBLE_EQ(sun.irradiance_W_m2_nm(510.0, 30.0), 7.0 / 3.0);
  EXPECT_DOUBLE_EQ(sun.irradiance_W_m2_nm(497.0, 1.0), 1.0);  // inside a band
  EXPECT_DOUBLE_EQ(sun.integral_W_m2(495.0, 525.0), 70.0);
  EXPECT_DOUBLE_EQ(sun.integral_W_m2(503.0, 503.0), 0.0);
}

TEST(SolarSpectrum, WrongUseIsRefused) {
  const SolarSpectrum sun({500.0, 510.0, 520.0}, {1.0, 2.0, 4.0});
  EXPECT_THROW(sun.irradiance_W_m2_nm(495.0, 10.0), InputError);
  EXPECT_THROW(sun.irradiance_W_m2_nm(510.0, 0.0), InputError);
  EXPECT_THROW(sun.irradiance_W_m2_nm(NAN, 5.0), InputError);
  EXPECT_THROW(SolarSpectrum({500.0, 510.0, 530.0}, {1.0, 2.0, 4.0}), InputError);
  EXPECT_THROW(SolarSpectrum({500.0, 510.0}, {1.0, NAN}), InputError);
  EXPECT_THROW(SolarSpectrum({500.0}, {1.0}), InputError);
}

}  // namespace
}  // namespace skylut
