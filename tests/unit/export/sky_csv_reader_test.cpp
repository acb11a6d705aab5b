#include "skylut/export/sky_csv_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class SkyCsvReader : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  SkyCsv read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_sky_csv(file_);
  }
  std::string message(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return fs::path(error.what()).filename().string();
    }
    return "no error";
  }
  const fs::path folder_ = fs::temp_directory_path() / "skylut_sky_csv_reader_test";
  const fs::path file_ = folder_ / "sky.csv";
};

TEST_F(SkyCsvReader, TakesItsColumnsInAnyOrderAndIgnoresOthers) {
  const SkyCsv sky = read(
      "# sun_zenith_deg=45\n# sun_azimuth_deg=90\nY_cd_m2,x,y,L_550,azimuth_deg,zenith_deg\n"
      "1000,0.3,0.31,0.5,12,10\n");
  ASSERT_EQ(sky.rows.size(), 1u);
  EXPECT_EQ(sky.rows[0].zenith_deg, 10.0);
  EXPECT_EQ(sky.rows[0].azimuth_deg, 12.0);
  EXPECT_FALSE(sky.rows[0].gamma_deg.has_value());
  EXPECT_EQ(sky.rows[0].colour, (Yxy{1000.0, 0.3, 0.31}));
  EXPECT_EQ(sky.rows[0].line, 4u);
  EXPECT_EQ(sky.sun_zenith_deg, 45.0);
  EXPECT_EQ(sky.sun_azimuth_deg, 90.0);
}

TEST_F(SkyCsvReader, TakesTheAngleToTheSunInstead) {
  const SkyCsv sky = read("zenith_deg,gamma_deg,Y,x,y\n0,30,1,0.3,0.3\n");
  EXPECT_EQ(sky.rows[0].gamma_deg, 30.0);
  EXPECT_FALSE(sky.sun_zenith_deg.has_value());
}

TEST_F(SkyCsvReader, SaysWhatIsWrong) {
  EXPECT_EQ(message("zenith_deg,Y,x,y\n0,1,0.3,0.3\n"),
            "sky.csv: neither column 'azimuth_deg' nor 'gamma_deg': the header must name one of them");
  EXPECT_EQ(message("zenith_deg,gamma_deg,Y,x,y\n95,30,1,0.3,0.3\n"),
            "sky.csv:2: zenith_deg 95: must lie within 0-90");
  EXPECT_EQ(message("zenith_deg,gamma_deg,Y,x,y\n0,30,0,0.3,0.3\n"),
            "sky.csv:2: Y 0: must be greater than 0");
  EXPECT_EQ(message("zenith_deg,gamma_deg,Y,x,y\n"), "sky.csv: holds no rows: must have at least one");
  EXPECT_EQ(message("zenith_deg,gamma_deg,Y,x,y\n0,30,1,,0.3\n"),
            "sky.csv:2: column 'x': '': must be a finite number");
}

}  // namespace
}  // namespace skylut
