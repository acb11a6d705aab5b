#include "skylut/atmosphere/solar_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Published integrals over 360-830 nm: ASTM G-173-03 734.8, Gueymard 738.8, Kurucz 737.3 W/m²; half bands at
// the ends of the latter two are read as constant.
TEST(SolarSpectrum, IntegralsOfTheSources) {
  const SolarSpectrum astm = SolarSpectrum::load(test::context);
  EXPECT_NEAR(astm.integral_W_m2(360.0, 830.0), 734.78, 0.01);
  EXPECT_NEAR(astm.integral_W_m2(380.0, 780.0), 655.9, 0.3);
  EXPECT_NEAR(SolarSpectrum::load(test::context, "gueymard2003").integral_W_m2(360.0, 830.0), 738.83, 0.05);
  EXPECT_NEAR(SolarSpectrum::load(test::context, "kurucz1992").integral_W_m2(360.0, 830.0), 737.32, 0.05);
  for (const std::string& name : SolarSpectrum::names()) {
    const double integral = SolarSpectrum::load(test::context, name).integral_W_m2(360.0, 830.0);
    EXPECT_TRUE(integral > 734.6 && integral < 739.0) << name << " " << integral;
  }
}

// Bands that touch hold all the light, whatever their width.
TEST(SolarSpectrum, BandsAddUp) {
  const SolarSpectrum sun = SolarSpectrum::load(test::context);
  for (const double step_nm : {0.5, 1.0, 2.5, 5.0, 20.0}) {
    double sum = 0.0;
    for (double centre = 400.0 + 0.5 * step_nm; centre < 700.0; centre += step_nm)
      sum += step_nm * sun.irradiance_W_m2_nm(centre, step_nm);
    EXPECT_NEAR(sum, sun.integral_W_m2(400.0, 700.0), 1e-9) << step_nm;
  }
}

// The deep Ca II K line is in the 1 nm file: 5 nm means used to hide it.
TEST(SolarSpectrum, FraunhoferLinesAreThere) {
  const SolarSpectrum sun = SolarSpectrum::load(test::context);
  EXPECT_LT(sun.irradiance_W_m2_nm(393.5, 1.0), 0.7 * sun.irradiance_W_m2_nm(391.0, 1.0));
  EXPECT_LT(sun.irradiance_W_m2_nm(656.0, 1.0), 0.9 * sun.irradiance_W_m2_nm(660.0, 1.0));
}

TEST(SolarSpectrum, AFileOfOnesOwn) {
  const std::string path = testing::TempDir() + "solar_spectrum_test.csv";
  std::ofstream(path) << "wavelength_nm,irradiance_W_m2_nm\n300,1\n500,2\n1100,2\n";
  EXPECT_DOUBLE_EQ(SolarSpectrum::load(test::context, path).irradiance_W_m2_nm(400.0, 10.0), 1.5);
  EXPECT_DOUBLE_EQ(SolarSpectrum::load(test::context, path).integral_W_m2(500.0, 600.0), 200.0);
  std::ofstream(path) << "wavelength_nm,irradiance_W_m2_nm\n300,1000\n500,2000\n";  // mW
  EXPECT_THROW(SolarSpectrum::load(test::context, path), InputError);
  std::filesystem::remove(path);
  EXPECT_THROW(SolarSpectrum::load(test::context, "astm"), InputError);
}

// SPCTRAL2 (Bird and Riordan 1986) has 1.891 at 530 nm and 1.728 at 610 nm: the maximum's flat side.
TEST(SolarSpectrum, GreenLight) {
  EXPECT_NEAR(SolarSpectrum::load(test::context).irradiance_W_m2_nm(555.0, 5.0), 1.88, 0.03);
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
