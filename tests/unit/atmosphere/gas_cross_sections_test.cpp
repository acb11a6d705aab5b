#include "skylut/atmosphere/gas_cross_sections.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "support/test_context.hpp"

namespace skylut {
namespace {

// Numbers of a reference table by row; empty cells are 0.
std::vector<std::vector<double>> reference(const char* name) {
  std::ifstream file(std::filesystem::path(SKYLUT_SHARED_REFERENCE) / "data" / name);
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      rows.back().push_back(cell.empty() ? 0.0 : std::stod(cell));
  }
  return rows;
}

TEST(NitrogenDioxide, IntegralAndPeak) {
  const CrossSection no2 = load_nitrogen_dioxide_cross_section(test::context);
  double sum = 0.0;
  for (double nm = 400.0; nm <= 600.0; nm += 5.0) sum += 5.0 * no2.at_m2(nm, 243.0);
  EXPECT_NEAR(sum / 5.927e-21, 1.0, 0.001);  // as the header of the file says
  // Maximum near 400-415 nm, about 6e-19 cm².
  EXPECT_NEAR(no2.at_m2(410.0, 293.0), 6.0e-23, 0.6e-23);
  EXPECT_EQ(no2.at_m2(900.0, 243.0), 0.0);
  EXPECT_EQ(no2.at_m2(410.0, 200.0), no2.at_m2(410.0, 223.0));
}

// A quadratic through four temperatures: Bogumil's values come back within 1 % where they are large
// (least squares over four points with three unknowns).
TEST(NitrogenDioxide, ReferenceTable) {
  const auto rows = reference("no2_xs.csv");
  if (rows.empty()) GTEST_SKIP() << "no reference figures beside the source tree";
  const CrossSection no2 = load_nitrogen_dioxide_cross_section(test::context);
  for (const std::vector<double>& row : rows) {
    if (row[0] < 300.0 || row[0] > 600.0) continue;
    const double temperature_K[] = {223.0, 243.0, 273.0, 293.0};
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(no2.at_m2(row[0], temperature_K[i]) / (1e-4 * row[i + 1]), 1.0, 0.01) << row[0];
  }
}

// Greenblatt et al. 1990: the strongest band in the visible, 577 nm, is 1.1e-45 cm^5 at its peak; over
// 5 nm less. The 630 nm band is weaker.
TEST(OxygenPairs, Bands) {
  const CrossSection pairs = load_oxygen_pair_cross_section(test::context);
  EXPECT_NEAR(pairs.at_m2(577.0, 250.0), 9.4e-56, 0.3e-56);
  EXPECT_NEAR(pairs.at_m2(630.0, 250.0), 7.0e-56, 0.1e-56);
  EXPECT_EQ(pairs.at_m2(550.0, 250.0), 0.0);
  EXPECT_EQ(pairs.at_m2(577.0, 200.0), pairs.at_m2(577.0, 300.0));
}

TEST(OxygenPairs, ReferenceTable) {
  const auto rows = reference("o4_xs.csv");
  if (rows.empty()) GTEST_SKIP() << "no reference figures beside the source tree";
  const CrossSection pairs = load_oxygen_pair_cross_section(test::context);
  for (const std::vector<double>& row : rows) {
    if (row[0] > 680.0) continue;
    EXPECT_NEAR(pairs.at_m2(row[0], 296.0), 1e-56 * row[1], 1e-59 + 1e-4 * 1e-56 * row[1]) << row[0];
  }
}

}  // namespace
}  // namespace skylut
