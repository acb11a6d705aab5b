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

constexpr const char* kFirstColumns =
    "altitude_km,turbidity,sun_zenith_deg,sun_azimuth_deg,A_Y,B_Y,C_Y,D_Y,E_Y,A_x,B_x,C_x,D_x,E_x,A_y,B_y,C_"
    "y,"
    "D_y,E_y,Y_zenith_kcd_m2,x_zenith,y_zenith,rmse_Y_rel,rmse_x,rmse_y";

// The header as the project's contract with scripts has it.
TEST_F(TableCsv, Header) {
  EXPECT_EQ(
      table_csv_header(),
      "altitude_km,turbidity,sun_zenith_deg,sun_azimuth_deg,A_Y,B_Y,C_Y,D_Y,E_Y,A_x,B_x,C_x,D_x,E_x,A_"
      "y,B_y,C_y,"
      "D_y,E_y,Y_zenith_kcd_m2,x_zenith,y_zenith,rmse_Y_rel,rmse_x,rmse_y,"
      "rmse_horizon_Y_rel,rmse_horizon_x,rmse_horizon_y,worst_Y_rel,worst_Y_zenith_deg,worst_Y_azimuth_deg,"
      "worst_x,worst_x_zenith_deg,worst_x_azimuth_deg,worst_y,worst_y_zenith_deg,worst_y_azimuth_deg,"
      "horizon_zenith_deg,Y_below_90_kcd_m2,light_below_90,undetermined_Y,undetermined_x,undetermined_y,"
      "at_bound_Y,at_bound_x,at_bound_y");
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
  entry.horizon_zenith_deg = 93.5;
  entry.notes_x = {1e-3, -0.1 / 3.0, {89.5, 12.0}, "11000", "01000"};
  entry.Y_below_90_kcd_m2 = 5.4;
  entry.light_below_90 = 0.07;
  const std::vector<TableEntry> entries{entry, entry};
  write_table_csv(file_, entries);
  EXPECT_EQ(read_table_csv(file_), entries);
}

// Tables of skylut 0.1 have the first columns only.
TEST_F(TableCsv, ReadsTablesWithoutTheLaterColumns) {
  std::ofstream(file_, std::ios::binary) << kFirstColumns << "\n"
                                         << "12,0.5,45,90,-1,-0.3,5,-2,0.4,0,-1,0,-1,0,0,"
                                         << "-1,0,-1,0,4.5,0.25,0.26,0.01,0.001,0.002\n";
  const TableEntry entry = read_table_csv(file_).front();
  EXPECT_EQ(entry.Y, (PerezCoefficients{-1.0, -0.3, 5.0, -2.0, 0.4}));
  EXPECT_EQ(entry.rmse_y, 0.002);
  EXPECT_EQ(entry.horizon_zenith_deg, 90.0);
  EXPECT_EQ(entry.notes_Y, FormulaNotes{});
}

TEST_F(TableCsv, RefusesAHorizonThatIsNone) {
  EXPECT_EQ(
      message(std::string(kFirstColumns) + ",horizon_zenith_deg\n12,0.5,45,90,-1,-0.3,5,-2,0.4,0,-1,0,-1,0,0,"
                                           "-1,0,-1,0,4.5,0.25,0.26,0.01,0.001,0.002,80\n"),
      "table.csv:2: horizon_zenith_deg 80: must lie within 90 to below 180");
}

TEST_F(TableCsv, SaysWhatIsWrong) {
  const std::string header = std::string(kFirstColumns) + "\n";
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
