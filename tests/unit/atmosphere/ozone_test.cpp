#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "skylut/atmosphere/gas_cross_sections.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

TEST(Ozone, IntegralOfTheFile) {
  const CrossSection ozone = load_ozone_cross_section(test::context);
  double sum = 0.0;
  for (double wavelength_nm = 450.0; wavelength_nm <= 750.0; wavelength_nm += 5.0)
    sum += 5.0 * ozone.at_m2(wavelength_nm, 228.0);
  EXPECT_NEAR(sum, 6.725e-23, 0.001e-23);
}

// Chappuis maximum near 603 nm, hardly dependent on temperature; Huggins bands that are.
TEST(Ozone, TemperatureDependence) {
  const CrossSection ozone = load_ozone_cross_section(test::context);
  EXPECT_NEAR(ozone.at_m2(600.0, 293.0) / ozone.at_m2(600.0, 203.0), 1.0, 0.01);
  EXPECT_GT(ozone.at_m2(325.0, 293.0), 1.3 * ozone.at_m2(325.0, 203.0));
  // Beyond the measured temperatures: the nearest.
  EXPECT_EQ(ozone.at_m2(325.0, 170.0), ozone.at_m2(325.0, 203.0));
  EXPECT_EQ(ozone.at_m2(325.0, 320.0), ozone.at_m2(325.0, 293.0));
  EXPECT_NEAR(ozone.at_m2(602.5, 228.0), 0.5 * (ozone.at_m2(600.0, 228.0) + ozone.at_m2(605.0, 228.0)),
              1e-31);
}

// Every Bogumil value of the reference table, at its five temperatures, within the rounding of both.
TEST(Ozone, ReferenceTable) {
  const std::filesystem::path path = std::filesystem::path(SKYLUT_SHARED_REFERENCE) / "data/ozone_xs.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference figures beside the source tree";
  const CrossSection ozone = load_ozone_cross_section(test::context);
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    const double wavelength_nm = std::stod(cell);
    if (wavelength_nm < 300.0) continue;
    for (double temperature_K : {203.0, 223.0, 243.0, 273.0, 293.0}) {
      std::getline(cells, cell, ',');
      EXPECT_NEAR(ozone.at_m2(wavelength_nm, temperature_K) / (1e-4 * std::stod(cell)), 1.0, 2e-4)
          << wavelength_nm << " nm " << temperature_K << " K";
    }
  }
}

TEST(Ozone, OutsideTheTableIsRefused) {
  const CrossSection ozone = load_ozone_cross_section(test::context);
  EXPECT_THROW(ozone.at_m2(299.0, 228.0), InputError);
  EXPECT_THROW(ozone.at_m2(1001.0, 228.0), InputError);
  EXPECT_THROW(ozone.at_m2(NAN, 228.0), InputError);
}

}  // namespace
}  // namespace skylut
