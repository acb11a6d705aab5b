#include "skylut/atmosphere/spectral_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(SpectralCurve, LinesAndTheirIntegrals) {
  const SpectralCurve curve = SpectralCurve::through_points({400.0, 500.0, 600.0}, {0.0, 1.0, 0.5});
  EXPECT_DOUBLE_EQ(curve.at(400.0), 0.0);
  EXPECT_DOUBLE_EQ(curve.at(450.0), 0.5);
  EXPECT_DOUBLE_EQ(curve.at(600.0), 0.5);
  EXPECT_DOUBLE_EQ(curve.integral(400.0, 600.0), 50.0 + 75.0);
  EXPECT_DOUBLE_EQ(curve.integral(450.0, 500.0), 37.5);
  EXPECT_DOUBLE_EQ(curve.integral(475.0, 525.0), 25.0 * 0.875 + 25.0 * 0.9375);  // across a bend
  EXPECT_DOUBLE_EQ(curve.lowest(), 0.0);
  EXPECT_DOUBLE_EQ(curve.highest(), 1.0);
}

TEST(SpectralCurve, BandsKeepTheirMeans) {
  const SpectralCurve curve = SpectralCurve::of_bands({500.0, 510.0}, {1.0, 3.0});
  EXPECT_DOUBLE_EQ(curve.first_nm(), 495.0);
  EXPECT_DOUBLE_EQ(curve.last_nm(), 515.0);
  EXPECT_DOUBLE_EQ(curve.integral(495.0, 505.0), 10.0);
  EXPECT_DOUBLE_EQ(curve.integral(500.0, 510.0), 20.0);
}

TEST(SpectralCurve, OutsideIsRefused) {
  const SpectralCurve curve = SpectralCurve::through_points({400.0, 500.0}, {0.0, 1.0});
  EXPECT_THROW(curve.at(399.9), InputError);
  EXPECT_THROW(curve.at(NAN), InputError);
  EXPECT_THROW(curve.integral(450.0, 500.1), InputError);
  EXPECT_THROW(curve.integral(460.0, 450.0), InputError);
  EXPECT_THROW(SpectralCurve::through_points({500.0, 400.0}, {0.0, 1.0}), InputError);
  EXPECT_THROW(SpectralCurve::through_points({400.0, 500.0}, {0.0, NAN}), InputError);
  EXPECT_THROW(SpectralCurve::of_bands({400.0, 500.0, 610.0}, {0.0, 1.0, 1.0}), InputError);
}

TEST(SpectralCurve, FilesAreReadAndRefusedByLine) {
  const std::string path = testing::TempDir() + "spectral_curve_test.csv";
  const auto read = [&](const char* text) {
    std::ofstream(path) << text;
    return read_spectral_curve(path, "albedo", 0.0, 1.0);
  };
  EXPECT_DOUBLE_EQ(read("albedo,wavelength_nm\n0.1,400\n0.3,500\n").at(450.0), 0.2);
  const auto refused = [&](const char* text, const std::string& named) {
    try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  refused("wavelength_nm,albedo\n400,0.1\n500,1.2\n", ":3: albedo 1.2");
  refused("wavelength_nm,albedo\n400,0.1\n400,0.2\n", ":3: wavelength 400");
  refused("wavelength_nm,albedo\n400,0.1\n", "1 rows");
  refused("wavelength_nm,reflectance\n400,0.1\n", "albedo");
  std::filesystem::remove(path);
}

TEST(SpectralCurve, NamesAndFilesAreToldApart) {
  EXPECT_TRUE(names_a_csv_file("mine.csv"));
  EXPECT_TRUE(names_a_csv_file("./mine"));
  EXPECT_FALSE(names_a_csv_file("grass"));
  EXPECT_FALSE(names_a_csv_file("0.2"));
}

}  // namespace
}  // namespace skylut
