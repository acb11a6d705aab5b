#include "skylut/table/table_csv.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class TableCsv : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string message(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    try {
      read_table_csv(file_);
    } catch (const InputError& error) {
      return fs::path(error.what()).filename().string();
    }
    return "no error";
  }
  const fs::path folder_ = fs::temp_directory_path() / "skylut_table_csv_test";
  const fs::path file_ = folder_ / "table.csv";
};

// The header as the project's contract with scripts has it.
TEST_F(TableCsv, Header) {
  EXPECT_EQ(table_csv_header(),
            "altitude_km,turbidity,sun_zenith_deg,sun_azimuth_deg,A_Y,B_Y,C_Y,D_Y,E_Y,A_x,B_x,C_x,D_x,E_x,A_"
            "y,B_y,C_y,"
            "D_y,E_y,Y_zenith_kcd_m2,x_zenith,y_zenith,rmse_Y_rel,rmse_x,rmse_y");
}

TEST_F(TableCsv, ReadsBackTheSameBits) {
  TableEntry entry;
  entry.altitude_km = 12.0;
  entry.turbidity = 0.1;
  entry.sun = {45.0, 270.0};
  entry.Y = {-1.0 / 3.0, -1e-5, 1e-16, -3.14159265358979, 2e30};
  entry.x = {1.0, -2.0, 3.0, -4.0, 5.0};
  entry.y = {0.1, -0.2, 0.3, -0.4, 0.5};
  entry.zenith = {4.4686, 0.25, 0.26};
  entry.rmse_Y_rel = 0.01;
  entry.rmse_x = 1e-3;
  entry.rmse_y = 2e-3;
  const std::vector<TableEntry> entries{entry, entry};
  write_table_csv(file_, entries);
  EXPECT_EQ(read_table_csv(file_), entries);
}

TEST_F(TableCsv, SaysWhatIsWrong) {
  const std::string header = table_csv_header() + "\n";
  EXPECT_EQ(message(header), "table.csv: holds no rows: must have at least one");
  EXPECT_NE(message("a,b\n1,2\n").find("no column 'altitude_km'"), std::string::npos);
  std::string zeros = "0";
  for (int i = 0; i < 24; ++i) zeros += ",0";
  EXPECT_EQ(message(header + zeros + "\n"), "table.csv:2: Y_zenith_kcd_m2 0: must be greater than 0");
  EXPECT_EQ(message(header + "0,0,200" + zeros.substr(5) + "\n"),
            "table.csv:2: sun_zenith_deg 200: must lie within 0-180");
  EXPECT_EQ(message(header + "0,x,20" + zeros.substr(5) + "\n"),
            "table.csv:2: column 'turbidity': 'x': must be a finite number");
}

}  // namespace
}  // namespace skylut
