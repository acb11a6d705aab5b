#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "skylut/core/errors.hpp"
#include "skylut/profile/profile.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

// A small valid profile with its levels out of order.
const std::string kValid = R"(name = "mine"
description = "three levels"
source = "invented"
[column.altitude]
unit = "km"
source = "x"
values = [30, 0, 10]
[column.temperature]
unit = "degC"
source = "x"
values = [-47, 15, -50]
[column.pressure]
unit = "Pa"
source = "x"
values = [1200, 101325, 26500]
[column.ozone]
unit = "ppmv"
source = "x"
values = [7, 0.03, 0.1]
[column.aerosol]
unit = "1"
source = "x"
values = [0, 10, 1]
)";

class ProfileFileTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& text) const {
    const std::string path = (folder_ / "p.toml").string();
    std::ofstream(path) << text;
    return path;
  }
  // The error for kValid with one piece replaced, without the folder's name.
  std::string refusal(const std::string& from, const std::string& to) const {
    std::string text = kValid;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
      load_profile(test::context, write(text));
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      const std::string folder = folder_.string() + "/";
      return message.starts_with(folder) ? message.substr(folder.size()) : message;
    }
    return "no error";
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("skylut_profile_file_test." + std::to_string(::getpid()));
};

TEST_F(ProfileFileTest, LevelsInAnyOrderAndUnits) {
  const Profile profile = load_profile(test::context, write(kValid));
  EXPECT_EQ(profile.name, "mine");
  EXPECT_EQ(profile.described_top_km, 30.0);
  EXPECT_NEAR(air_state(profile, 10.0).temperature_K, 223.15, 1e-9);
  EXPECT_NEAR(profile.temperature_K[0], 288.15, 1e-12);
  EXPECT_NEAR(air_state(profile, 30.0).pressure_hPa, 12.0, 1e-12);
  const AirState ground = air_state(profile, 0.0);
  EXPECT_NEAR(profile.gas("ozone")->density_per_m3[0] / ground.density_per_m3, 0.03e-6, 1e-18);
  EXPECT_NEAR(profile.gas("oxygen")->density_per_m3[0] / ground.density_per_m3, 0.209476, 1e-12);
  EXPECT_EQ(profile.relative_aerosol_extinction[0], 10.0);
  ASSERT_EQ(profile.columns.size(), 5u);
  EXPECT_EQ(profile.columns[1].name, "temperature");
  EXPECT_EQ(profile.columns[1].unit, "degC");
  EXPECT_EQ(profile.columns[1].values, (std::vector<double>{15, -50, -47}));
}

// Above its last level a short profile goes on with the standard's shape, joined without a step.
TEST_F(ProfileFileTest, ShortProfileIsContinued) {
  const Profile profile = load_profile(test::context, write(kValid));
  const Profile standard = load_profile(test::context, "ussa1976");
  EXPECT_EQ(profile.altitude_km.back(), 100.0);
  EXPECT_EQ(profile.altitude_km.size(), profile.temperature_K.size());
  EXPECT_EQ(profile.altitude_km.size(), profile.relative_aerosol_extinction.size());
  for (const GasProfile& gas : profile.gases)
    EXPECT_EQ(gas.density_per_m3.size(), profile.altitude_km.size());
  const double ratio = 12.0 / air_state(standard, 30.0).pressure_hPa;
  EXPECT_NEAR(air_state(profile, 80.0).pressure_hPa / air_state(standard, 80.0).pressure_hPa, ratio, 1e-12);
  EXPECT_EQ(air_state(profile, 80.0).temperature_K, air_state(standard, 80.0).temperature_K);
}

TEST_F(ProfileFileTest, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("source = \"invented\"", "sauce = \"invented\""),
            "p.toml:3: sauce: unknown key; expected one of name, description, source, ground_m, "
            "temperature_and_pressure_of, standard_layers, total, report_2005, column");
  EXPECT_EQ(refusal("[column.ozone]", "[column.argon]"),
            "p.toml:16: column.argon: unknown key; expected one of altitude, temperature, pressure, ozone, "
            "water_vapour, nitrogen_dioxide, oxygen, carbon_dioxide, aerosol");
  EXPECT_EQ(refusal("[column.ozone]\nunit = \"ppmv\"\nsource = \"x\"\nvalues = [7, 0.03, 0.1]\n", ""),
            "p.toml: column.ozone: is missing; expected a table with unit, source, values");
  EXPECT_EQ(refusal("[column.pressure]\nunit = \"Pa\"\nsource = \"x\"\nvalues = [1200, 101325, 26500]\n", ""),
            "p.toml: column.pressure: is missing; expected a table with unit, source, values");
  EXPECT_EQ(refusal("unit = \"Pa\"", "unit = \"atm\""),
            "p.toml:13: column.pressure.unit: unknown unit 'atm'; expected hPa or mbar or Pa");
  EXPECT_EQ(refusal("[7, 0.03, 0.1]", "[7, nan, 0.1]"),
            "p.toml:19: column.ozone.values[1] = nan: must be a finite number");
  EXPECT_EQ(refusal("[7, 0.03, 0.1]", "[7, 0.03, -0.1]"),
            "p.toml:19: column.ozone.values[2] = -0.1: must not be negative");
  EXPECT_EQ(refusal("[7, 0.03, 0.1]", "[7, 0.03]"),
            "p.toml:19: column.ozone.values: has 2 values; must have 3, one for every altitude");
  EXPECT_EQ(refusal("[7, 0.03, 0.1]", "[7, \"0.03\", 0.1]"),
            "p.toml:19: column.ozone.values: entry 1 is no number");
  EXPECT_EQ(refusal("[30, 0, 10]", "[30, 0, 30]"),
            "p.toml:7: column.altitude.values[2] = 30: this altitude is given twice; must be given once");
  EXPECT_EQ(
      refusal("[30, 0, 10]", "[30, 9.1, 10]"),
      "p.toml:7: column.altitude.values[1] = 9.1: the lowest level is the ground: must lie within -0.5 to 9 "
      "km");
  EXPECT_EQ(refusal("[30, 0, 10]", "[9.9, 0, 9]"),
            "p.toml:7: column.altitude.values[0] = 9.9: the highest level must be at 10 km or above");
  EXPECT_EQ(refusal("source = \"invented\"", "source = \"invented\"\nground_m = 9001"),
            "p.toml:4: ground_m: is 9001; must lie within -500 to 9000 m above sea level");
  EXPECT_EQ(refusal("source = \"invented\"", "source = \"invented\"\nground_m = -10"),
            "p.toml:4: ground_m: is -10; must not lie below the lowest level, 0 km");
  // 10 km that cost no more than 3 hPa.
  EXPECT_TRUE(refusal("[1200, 101325, 26500]", "[1200, 101325, 101000]")
                  .starts_with("p.toml: between 0 and 10 km the pressures ask for air 418 times as warm as"))
      << refusal("[1200, 101325, 26500]", "[1200, 101325, 101000]");
  EXPECT_EQ(refusal("[1200, 101325, 26500]", "[1200, 101325, -26500]"),
            "p.toml:15: column.pressure.values[2] = -26500: must be greater than 0 and at most 2000 hPa");
  EXPECT_EQ(refusal("[1200, 101325, 26500]", "[1200, 101325, 126500]"),
            "p.toml:15: column.pressure.values[2] = 126500: must be less than at the level below (0 km)");
  EXPECT_EQ(refusal("[-47, 15, -50]", "[-47, 15, -300]"),
            "p.toml:11: column.temperature.values[2] = -300: must be greater than absolute zero and at most "
            "2000 K");
  EXPECT_EQ(refusal("[0, 10, 1]", "[0, 0, 0]"),
            "p.toml:23: column.aerosol.values: are all 0; one must be greater, or leave the column out");
  EXPECT_EQ(refusal("name = \"mine\"", "name = 5"), "p.toml:1: name: must be a text in quotes, not empty");
  EXPECT_EQ(refusal("[column.altitude]", "[total]\nozone_du = -3\n[column.altitude]"),
            "p.toml:5: total.ozone_du: is -3; must not be negative");
  EXPECT_EQ(
      refusal("source = \"invented\"", "source = \"invented\"\ntemperature_and_pressure_of = \"ussa1976\""),
      "p.toml:9: column.temperature: is given although it is computed; leave one of them out");
}

TEST_F(ProfileFileTest, BrokenSyntaxNamesTheLine) {
  EXPECT_TRUE(refusal("[30, 0, 10]", "[30, 0, 10").starts_with("p.toml:8: broken TOML: "))
      << refusal("[30, 0, 10]", "[30, 0, 10");
  EXPECT_TRUE(refusal(kValid, "[*P").starts_with("p.toml:1: broken TOML: "));
  EXPECT_TRUE(refusal(kValid, "\nZ\xCC\x8D").starts_with("p.toml:2: broken TOML: "));
}

TEST_F(ProfileFileTest, WhichProfile) {
  const auto message = [](const std::string& name) -> std::string {
    try {
      load_profile(test::context, name);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("ussa1967"),
            "profile 'ussa1967': must be one of midlatitude-summer, midlatitude-winter, "
            "subarctic-summer, subarctic-winter, tropical, ussa1976, utm2005, or a .toml file, did you mean "
            "ussa1976?");
  EXPECT_EQ(message("./none.toml"), "profile './none.toml': no such file");
  EXPECT_EQ(message(folder_.string()), "profile '" + folder_.string() + "': no such file");
  EXPECT_EQ(message(""),
            "profile '': must be one of midlatitude-summer, midlatitude-winter, "
            "subarctic-summer, subarctic-winter, tropical, ussa1976, utm2005, or a .toml file");
}

}  // namespace
}  // namespace skylut
