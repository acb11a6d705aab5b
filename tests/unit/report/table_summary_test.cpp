#include "skylut/report/table_summary.hpp"

#include <gtest/gtest.h>

namespace skylut {
namespace {

SkyTable one_row() {
  SkyTable table;
  table.entries.resize(1);
  table.entries[0].altitude_km = 12.0;
  table.entries[0].turbidity = 0.5;
  table.entries[0].sun = {45.0, 90.0};
  table.entries[0].zenith = {0.390, 0.2412, 0.2501};
  table.entries[0].rmse_Y_rel = 0.0123;
  table.fits.resize(1);
  for (FitReport* report : {&table.fits[0].Y, &table.fits[0].x, &table.fits[0].y}) {
    report->termination = Termination::converged;
    report->determined.fill(true);
  }
  return table;
}

TEST(TableSummary, ShowsZenithAndFit) {
  const std::string text = table_summary(one_row(), "aod500");
  for (const char* part : {"aod500", "0.39", "0.2412", "0.2501", "1.23", "1 rows", "in row 1"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  for (const char* part : {"undetermined", "at bound", "no convergence"})
    EXPECT_EQ(text.find(part), std::string::npos) << text;
}

TEST(TableSummary, SaysWhichCoefficientsNeedCare) {
  SkyTable table = one_row();
  table.fits[0].x.determined[3] = false;
  table.fits[0].Y.at_bound[1] = true;
  table.fits[0].y.termination = Termination::no_convergence;
  const std::string text = table_summary(table, "aod500");
  EXPECT_NE(text.find("undetermined: D_x"), std::string::npos) << text;
  EXPECT_NE(text.find("at bound: B_Y"), std::string::npos) << text;
  EXPECT_NE(text.find("no convergence"), std::string::npos) << text;
}

}  // namespace
}  // namespace skylut
