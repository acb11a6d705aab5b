#include "skylut/export/directions_csv.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class DirectionsCsv : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  const fs::path& file(const std::string& text) {
    std::ofstream(path_) << text;
    return path_;
  }
  const fs::path path_ = fs::temp_directory_path() / "skylut_directions_test.csv";
};

TEST_F(DirectionsCsv, ReadsColumnsInAnyOrder) {
  const auto directions =
      read_directions_csv(file("# mine\nazimuth_deg, note ,zenith_deg\r\n90,a,10\r\n\n-15,b,120.5\n"));
  EXPECT_EQ(directions, (std::vector<Direction>{{10.0, 90.0}, {120.5, 345.0}}));
}

TEST_F(DirectionsCsv, EveryMistakeNamesItsLine) {
  const auto message = [this](const std::string& text) -> std::string {
    try {
      read_directions_csv(file(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message("zenith_deg,azimuth_deg\n10,20\n181,0\n").find(":3: zenith_deg 181"), std::string::npos);
  EXPECT_NE(message("zenith_deg,azimuth_deg\n10\n").find(":2"), std::string::npos);
  EXPECT_NE(message("zenith_deg,azimuth_deg\nnan,0\n").find("'nan'"), std::string::npos);
  EXPECT_NE(message("zenith,azimuth\n1,2\n").find("zenith_deg"), std::string::npos);
  EXPECT_NE(message("zenith_deg,azimuth_deg\n").find("no rows"), std::string::npos);
  EXPECT_THROW(read_directions_csv(fs::temp_directory_path()), InputError);
  EXPECT_THROW(read_directions_csv("no/such/file.csv"), InputError);
}

}  // namespace
}  // namespace skylut
