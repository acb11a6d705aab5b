#include "skylut/core/csv.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

namespace fs = std::filesystem;

class Csv : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  CsvTable read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return CsvTable::read(file_);
  }
  std::string message(const std::string& text) {
    try {
      const CsvTable table = read(text);
      for (std::size_t row = 0; row < table.rows(); ++row)
        for (std::size_t column = 0; column < table.columns().size(); ++column) table.number(row, column);
    } catch (const InputError& error) {
      return fs::path(error.what()).filename().string();
    }
    return "no error";
  }
  const fs::path folder_ = fs::temp_directory_path() / "skylut_csv_test";
  const fs::path file_ = folder_ / "t.csv";
};

TEST_F(Csv, ReadsColumnsCommentsAndBlanks) {
  const CsvTable table = read("\xEF\xBB\xBF# sun_zenith_deg = 45\r\n a , b\r\n\r\n1, +2e-3 \r\n# end\n3,4");
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.number(0, table.column("b")), 2e-3);
  EXPECT_EQ(table.number(1, table.column("a")), 3.0);
  EXPECT_EQ(table.line(1), 6u);
  EXPECT_EQ(table.comment_number("sun_zenith_deg"), 45.0);
  EXPECT_FALSE(table.comment("sun").has_value());
  EXPECT_FALSE(table.find_column("c").has_value());
}

TEST_F(Csv, SaysWhereAndWhat) {
  EXPECT_EQ(message("a,b\n1,2\n3\n"), "t.csv:3: 1 fields: must be 2, as the header names");
  EXPECT_EQ(message("a,b\n1,x\n"), "t.csv:2: column 'b': 'x': must be a finite number");
  EXPECT_EQ(message("a\nnan\n"), "t.csv:2: column 'a': 'nan': must be a finite number");
  EXPECT_EQ(message("a\n1e999\n"), "t.csv:2: column 'a': '1e999': must be a finite number");
  EXPECT_EQ(message("a\n1,5\n"), "t.csv:2: 2 fields: must be 1, as the header names");
  EXPECT_EQ(message("a,a\n1,2\n"), "t.csv:1: column 'a' is named twice: every column must have its own name");
  EXPECT_EQ(message(""), "t.csv: is empty: the first line must name the columns");
  EXPECT_THROW(read("a\n1\n").column("b"), InputError);
  EXPECT_THROW(CsvTable::read(folder_), InputError);
  EXPECT_THROW(CsvTable::read(folder_ / "missing.csv"), InputError);
  EXPECT_THROW(read("# k=abc\na\n").comment_number("k"), InputError);
}

}  // namespace
}  // namespace skylut
