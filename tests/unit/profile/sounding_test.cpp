#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "profile/hydrostatic.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/scattering/rayleigh.hpp"
#include "support/test_context.hpp"

// Profiles as a balloon or a textbook gives them: few levels, from a hill, ended where the balloon burst.
namespace skylut {
namespace {

namespace fs = std::filesystem;

struct Levels {
  std::string altitude;  // with its unit's line
  std::string temperature_K;
  std::string pressure_hPa;
  std::string ozone_ppmv;
  std::string head;
};

class Sounding : public testing::Test {
 protected:
  Sounding()
      : file_(fs::temp_directory_path() / ("skylut-sounding-" + std::to_string(::getpid()) + ".toml")) {}
  ~Sounding() override { fs::remove(file_); }

  Profile load(const Levels& levels) const {
    const auto column = [](const std::string& name, const std::string& unit, const std::string& values) {
      return "[column." + name + "]\nunit = \"" + unit + "\"\nsource = \"test\"\nvalues = [" + values + "]\n";
    };
    std::ofstream(file_) << "name = \"sounding\"\ndescription = \"d\"\nsource = \"s\"\n"
                         << levels.head << column("altitude", "m", levels.altitude)
                         << column("temperature", "K", levels.temperature_K)
                         << column("pressure", "hPa", levels.pressure_hPa)
                         << column("ozone", "ppmv", levels.ozone_ppmv);
    return load_profile(test::context, file_.string());
  }

  fs::path file_;
};

const Levels kTwoLevels{"0, 30000", "288.15, 226.51", "1013.25, 11.97", "0, 0", ""};
const Levels kThreeLevels{"0, 10000, 30000", "288.15, 223.25, 226.51", "1013.25, 265.0, 11.97",
                          "0.03, 0.13, 6.5", ""};
const Levels kStation{"1830, 10000, 30000", "278.15, 223.25, 226.51", "815, 265.0, 11.97", "0.03, 0.13, 5",
                      ""};
const Levels kBurst{"0, 10000, 25000", "288.15, 223.25, 221.55", "1013.25, 265.0, 25.49", "0.03, 0.13, 5",
                    ""};

double air_above_per_m2(const Profile& profile, double altitude_km) {
  return air_column_per_m2(profile, altitude_km, profile.altitude_km.back());
}

double rayleigh_depth(const Profile& profile, double wavelength_nm) {
  return rayleigh_cross_section_m2(wavelength_nm, 360e-6) * air_above_per_m2(profile, 0.0);
}

// τ = σ p0/(m g): air of the standard's ground pressure weighs the same however few levels tell of it. What
// is left is g at the mean altitude of the air, which the levels' temperatures move by some 0.2 km.
TEST_F(Sounding, WeightFixesTheColumn) {
  const Profile standard = load_profile(test::context, "ussa1976");
  EXPECT_NEAR(rayleigh_depth(standard, 500.0), 0.1434, 5e-5);
  for (const Levels& levels : {kTwoLevels, kThreeLevels, kBurst}) {
    const Profile profile = load(levels);
    EXPECT_NEAR(rayleigh_depth(profile, 500.0), 0.1434, 1e-4) << levels.altitude;
    ASSERT_EQ(profile.notes.size(), 1u) << levels.altitude;
    EXPECT_NE(profile.notes[0].find("weight of the air"), std::string::npos);
    // The file's own levels stay as they are.
    EXPECT_EQ(profile.temperature_K.front(), 288.15);
    EXPECT_EQ(air_state(profile, levels.altitude == kBurst.altitude ? 25.0 : 30.0).pressure_hPa,
              levels.altitude == kBurst.altitude ? 25.49 : 11.97);
    EXPECT_LT(std::abs(hydrostatic_mismatch(profile, 0.0)), 5e-4);
    EXPECT_NEAR(
        gas_column_per_m2(profile, *profile.gas("oxygen"), 0.0, 100.0) / air_above_per_m2(profile, 0.0),
        0.209476, 5e-5);
  }
  EXPECT_NE(load(kTwoLevels).notes[0].find("(-9.9 % of the column)"), std::string::npos)
      << load(kTwoLevels).notes[0];
  EXPECT_NE(load(kTwoLevels).notes[0].find("at 0-30 km"), std::string::npos);
}

// The temperature that the pressures ask for lies near the true one: the standard's at 15 km is 216.65 K, the
// straight line of two levels says 257 K.
TEST_F(Sounding, PressuresTellTheTemperatureBetweenLevels) {
  EXPECT_NEAR(air_state(load(kTwoLevels), 15.0).temperature_K, 216.65, 8.0);
  EXPECT_NEAR(air_state(load(kTwoLevels), 10.0).pressure_hPa / 264.99, 1.0, 0.05);
}

TEST_F(Sounding, ProfilesThatComeWithSkylutAreInBalance) {
  for (const std::string& name : profile_names(test::context)) {
    const Profile profile = load_profile(test::context, name);
    EXPECT_LT(std::abs(hydrostatic_mismatch(profile, 0.0)), 0.0025) << name;
    EXPECT_TRUE(profile.notes.empty()) << name;
    EXPECT_FALSE(profile.ground_height_km) << name;
  }
}

// Altitudes of a file whose lowest level is a hill are above sea level; the profile's are above the hill.
TEST_F(Sounding, FromAHill) {
  const Profile profile = load(kStation);
  EXPECT_EQ(profile.ground_height_km, 1.83);
  EXPECT_EQ(profile.altitude_km.front(), 0.0);
  EXPECT_EQ(profile.altitude_km.back(), 100.0);
  EXPECT_EQ(profile.pressure_hPa.front(), 815.0);
  EXPECT_EQ(profile.temperature_K.front(), 278.15);
  EXPECT_NEAR(air_state(profile, 8.17).pressure_hPa, 265.0, 1e-9);
  EXPECT_NEAR(profile.described_top_km, 28.17, 1e-12);
  // The column weighs 815 hPa: 815/1013.25 of the standard's, with g 0.04 % less for air 1.3 km higher.
  EXPECT_NEAR(air_above_per_m2(profile, 0.0) / air_above_per_m2(load_profile(test::context, "ussa1976"), 0.0),
              815.0 / 1013.25 * 1.0004, 5e-4);
}

// ground_m cuts a sounding that began below, and says of one from 0 where its ground is.
TEST_F(Sounding, GroundOfTheFile) {
  Levels levels = kStation;
  levels.head = "ground_m = 3000\n";
  const Profile cut = load(levels);
  EXPECT_EQ(cut.ground_height_km, 3.0);
  EXPECT_NEAR(cut.pressure_hPa.front(), air_state(load(kStation), 1.17).pressure_hPa, 1e-9);
  levels = kThreeLevels;
  levels.head = "ground_m = 0\n";
  EXPECT_EQ(load(levels).ground_height_km, 0.0);
  EXPECT_EQ(load(levels).pressure_hPa, load(kThreeLevels).pressure_hPa);
}

// A balloon that burst at 25 km: standard air joins there, pressure and gases without a step, and the ozone
// above 30 km is the standard's.
TEST_F(Sounding, ContinuesFromTheBurst) {
  const Profile profile = load(kBurst);
  const Profile standard = load_profile(test::context, "ussa1976");
  EXPECT_EQ(profile.described_top_km, 25.0);
  EXPECT_EQ(profile.altitude_km.back(), 100.0);
  EXPECT_NEAR(air_state(profile, 40.0).pressure_hPa / air_state(standard, 40.0).pressure_hPa,
              25.49 / air_state(standard, 25.0).pressure_hPa, 1e-9);
  const auto ozone = [](const Profile& p, double z) {
    return interpolate_by_altitude(p, p.gas("ozone")->density_per_m3, z);
  };
  EXPECT_NEAR(ozone(profile, 25.0) / (5e-6 * air_state(profile, 25.0).density_per_m3), 1.0, 1e-9);
  EXPECT_NEAR(ozone(profile, 40.0) / ozone(standard, 40.0), 1.0, 1e-9);
  EXPECT_NEAR(gas_column_per_m2(profile, *profile.gas("ozone"), 0.0, 100.0) / kDobsonUnit_per_m2, 343.8,
              60.0);
}

// Tropospheric ozone three times the standard's says nothing of the stratosphere.
TEST_F(Sounding, LowEndDoesNotScaleTheStratosphere) {
  const Profile profile =
      load({"0, 5000, 12000", "288.15, 255.68, 216.65", "1013.25, 540.48, 193.99", "0.1, 0.2, 0.9", ""});
  EXPECT_LT(gas_column_per_m2(profile, *profile.gas("ozone"), 0.0, 100.0) / kDobsonUnit_per_m2, 520.0);
  EXPECT_GT(gas_column_per_m2(profile, *profile.gas("ozone"), 0.0, 100.0) / kDobsonUnit_per_m2, 343.8);
}

// A mountain of 4205 m under the standard atmosphere: 600.3 hPa (eq. 33a at 4202 geopotential m), an eighth
// of the water, and at air mass 2 a Rayleigh transmittance of 0.7509^(600.3/1013.25) = 0.844.
TEST(RaisedTo, AMountain) {
  const Profile standard = load_profile(test::context, "ussa1976");
  const Profile mountain = raised_to(standard, 4.205);
  EXPECT_EQ(mountain.altitude_km.front(), 0.0);
  EXPECT_GE(mountain.altitude_km.back(), 100.0);
  EXPECT_EQ(mountain.ground_height_km, 4.205);
  EXPECT_NEAR(mountain.pressure_hPa.front(), 600.33, 0.05);
  EXPECT_NEAR(mountain.temperature_K.front(), 260.83, 0.05);
  for (double z : {0.0, 0.3, 5.0, 30.0, 90.0}) {
    EXPECT_NEAR(air_state(mountain, z).pressure_hPa / air_state(standard, z + 4.205).pressure_hPa, 1.0, 1e-9)
        << z;
    EXPECT_NEAR(air_state(mountain, z).temperature_K, air_state(standard, z + 4.205).temperature_K, 1e-9)
        << z;
  }
  for (const GasProfile& gas : standard.gases)
    EXPECT_NEAR(gas_column_per_m2(mountain, *mountain.gas(gas.name), 0.0, 95.0) /
                    gas_column_per_m2(standard, gas, 4.205, 99.205),
                1.0, 1e-9)
        << gas.name;
  const auto water = [](const Profile& p) {
    return gas_column_per_m2(p, *p.gas("water_vapour"), 0.0, 100.0);
  };
  EXPECT_NEAR(water(standard) / water(mountain), 8.0, 1.5);
  constexpr double kAirMassAt60 = 1.995;
  EXPECT_NEAR(std::exp(-kAirMassAt60 * rayleigh_depth(mountain, 500.0)), 0.8437, 0.0005);
  ASSERT_EQ(mountain.notes.size(), 1u);
  EXPECT_NE(mountain.notes[0].find("4205 m above sea level"), std::string::npos) << mountain.notes[0];
}

TEST(RaisedTo, SeaLevelChangesNothing) {
  const Profile standard = load_profile(test::context, "ussa1976");
  const Profile same = raised_to(standard, 0.0);
  EXPECT_EQ(same.altitude_km, standard.altitude_km);
  EXPECT_EQ(same.pressure_hPa, standard.pressure_hPa);
  EXPECT_TRUE(same.notes.empty());
}

// The Dead Sea's shore, -430 m: the standard's formulas there give 1066 hPa and 290.9 K.
TEST(RaisedTo, BelowSeaLevel) {
  const Profile shore = raised_to(load_profile(test::context, "ussa1976"), -0.43);
  EXPECT_NEAR(shore.temperature_K.front(), 290.945, 0.005);
  EXPECT_NEAR(shore.pressure_hPa.front(), 1013.25 * std::pow(1.0 + 6.5 * 0.43 / 288.15, 5.2559), 0.05);
  EXPECT_EQ(air_state(shore, 0.43).pressure_hPa, 1013.25);
  EXPECT_NEAR(air_above_per_m2(shore, 0.0) / air_above_per_m2(load_profile(test::context, "ussa1976"), 0.0),
              shore.pressure_hPa.front() / 1013.25, 2e-4);
}

TEST(RaisedTo, AMountainAboveTheProfilesAerosol) {
  Profile profile = load_profile(test::context, "ussa1976");
  profile.relative_aerosol_extinction.assign(profile.altitude_km.size(), 0.0);
  profile.relative_aerosol_extinction[0] = 1.0;
  EXPECT_FALSE(raised_to(profile, 0.5).relative_aerosol_extinction.empty());
  const Profile above = raised_to(profile, 2.5);
  EXPECT_TRUE(above.relative_aerosol_extinction.empty());
  EXPECT_EQ(above.notes.size(), 2u);
  EXPECT_THROW(raised_to(profile, 9.5), InputError);
}

}  // namespace
}  // namespace skylut
