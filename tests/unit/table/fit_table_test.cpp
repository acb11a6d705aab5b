#include "skylut/table/fit_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"
#include "test_maps.hpp"

namespace skylut {
namespace {

void expect_near(const PerezCoefficients& found, const PerezCoefficients& expected) {
  // Made from the formula without noise: the fit ends at rounding, far below what a table shows.
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(found.values()[i], expected.values()[i], 1e-5) << kPerezNames[i];
}

const std::vector<TableSky> kTwoSkies{perez_table_sky(0.0, {60.0, 90.0}),
                                      perez_table_sky(12.0, {45.0, 90.0})};

TEST(FitTable, KnownSkiesComeBackInTheirRows) {
  for (const TableFitOptions& options : {TableFitOptions::half_floats(), TableFitOptions::utm2005()}) {
    const SkyTable table = fit_table(test::context, kTwoSkies, options);
    ASSERT_EQ(table.entries.size(), 2u);
    ASSERT_EQ(table.fits.size(), 2u);
    for (std::size_t row = 0; row < 2; ++row) {
      const TableEntry& entry = table.entries[row];
      EXPECT_EQ(entry.altitude_km, kTwoSkies[row].altitude_km);
      EXPECT_EQ(entry.turbidity, 0.5);
      EXPECT_EQ(entry.sun, kTwoSkies[row].sun);
      EXPECT_NEAR(entry.zenith.Y, 3.5, 1e-12);  // kcd/m² from cd/m²
      EXPECT_NEAR(entry.zenith.x, 0.25, 1e-12);
      expect_near(entry.Y, kMadeUp_Y);
      expect_near(entry.x, kMadeUp_x);
      expect_near(entry.y, kMadeUp_y);
      EXPECT_LT(entry.rmse_Y_rel, 1e-8);
      EXPECT_LT(entry.notes_Y.rmse_horizon, 1e-8);
    }
  }
}

// The formula stretched to a horizon at 94.5°: the same coefficients.
TEST(FitTable, TheFormulasHorizonMayLieBelow90) {
  const std::vector<TableSky> skies{perez_table_sky(20.0, {45.0, 0.0}, kMadeUp_Y, 94.5)};
  const SkyTable table = fit_table(test::context, skies, TableFitOptions::half_floats());
  EXPECT_EQ(table.entries[0].horizon_zenith_deg, 94.5);
  expect_near(table.entries[0].Y, kMadeUp_Y);
  EXPECT_LT(table.entries[0].rmse_Y_rel, 1e-8);
}

// A check that is 5 % brighter than the fit's directions, and 20 % in one of them.
TEST(FitTable, ErrorsAreThoseOfTheCheckBySolidAngle) {
  TableSky sky = perez_table_sky(0.0, {60.0, 90.0});
  for (Yxy& colour : sky.check.colour) colour.Y *= 1.05;
  const std::size_t far = sky.check.views.size() / 2;
  sky.check.colour[far].Y *= 1.2 / 1.05;
  const SkyTable table = fit_table(test::context, std::vector{sky}, TableFitOptions::half_floats());
  const TableEntry& row = table.entries[0];
  double all = 0.0;
  for (const double part : sky.check.solid_angles_sr) all += part;
  const double part = sky.check.solid_angles_sr[far] / all;
  const double usual = 1.0 - 1.0 / 1.05;
  const double worst = 1.0 - 1.0 / 1.2;
  EXPECT_NEAR(row.rmse_Y_rel, std::sqrt((1.0 - part) * usual * usual + part * worst * worst), 1e-7);
  EXPECT_NEAR(row.notes_Y.worst, -worst, 1e-7);
  EXPECT_EQ(row.notes_Y.worst_direction.zenith_deg, sky.check.views[far].zenith_deg);
  EXPECT_NEAR(row.notes_Y.worst_direction.azimuth_deg,
              wrapped_azimuth_deg(90.0 + sky.check.views[far].relative_azimuth_deg), 1e-9);
  ASSERT_LT(sky.check.views[far].zenith_deg, 89.0);
  EXPECT_LT(row.rmse_x, 1e-8);
}

// Without an aureole D means nothing, and a gradation steeper than any bound ends on it.
TEST(FitTable, FlagsAreDigits) {
  const std::vector<TableSky> skies{perez_table_sky(0.0, {50.0, 0.0}, {0.5, -1.0, 0.0, -1.0, 0.7})};
  const TableEntry row = fit_table(test::context, skies, TableFitOptions::half_floats()).entries[0];
  EXPECT_EQ(row.notes_Y.undetermined[3], '1');
  EXPECT_EQ(row.notes_Y.undetermined[4], '0');
  EXPECT_EQ(row.notes_x.undetermined, "00000");
  EXPECT_EQ(row.notes_x.at_bound, "00000");
  TableFitOptions narrow = TableFitOptions::half_floats();
  narrow.fit.B_upper = -1.5;
  EXPECT_EQ(fit_table(test::context, skies, narrow).entries[0].notes_Y.at_bound, "01000");
}

TEST(FitTable, MirrorImagesAreFittedOnce) {
  const std::vector<TableSky> skies{perez_table_sky(0.0, {60.0, 90.0}), perez_table_sky(0.0, {60.0, 270.0})};
  Context context = test::context;
  std::size_t fitted = 0;
  context.progress = [&](std::string_view, std::size_t, std::size_t) { ++fitted; };
  const SkyTable table = fit_table(context, skies, TableFitOptions::half_floats());
  EXPECT_EQ(fitted, 1u);
  EXPECT_EQ(table.entries[0].Y, table.entries[1].Y);
  EXPECT_EQ(table.entries[1].sun.azimuth_deg, 270.0);
}

TEST(FitTable, NamesTheRowsThatDidNotConverge) {
  SkyTable table = fit_table(test::context, kTwoSkies, TableFitOptions::half_floats());
  EXPECT_NO_THROW(require_converged(table));
  table.fits[1].x.termination = Termination::no_convergence;
  try {
    require_converged(table);
    FAIL() << "row 2 did not converge";
  } catch (const WorkError& error) {
    EXPECT_NE(std::string(error.what()).find("rows 2 (x)"), std::string::npos);
  }
}

TEST(FitTable, SaysWhatWasLookedAtTogether) {
  const std::vector<TableSky> grid{perez_table_sky(0.0, {60.0, 90.0}), perez_table_sky(12.0, {60.0, 90.0})};
  EXPECT_EQ(fit_table(test::context, grid, TableFitOptions::half_floats()).grid,
            "all 2 altitudes x 1 turbidities x 1 sun zenith angles together");
  EXPECT_EQ(fit_table(test::context, grid, TableFitOptions::utm2005()).grid,
            "none: every row is fitted alone");
  // A combination is missing.
  EXPECT_EQ(fit_table(test::context, kTwoSkies, TableFitOptions::half_floats()).grid,
            "none: every row is fitted alone");
}

TEST(FitTable, ThreadsChangeNothing) {
  const std::vector<TableSky> skies{perez_table_sky(0.0, {60.0, 90.0}), perez_table_sky(6.0, {30.0, 0.0}),
                                    perez_table_sky(12.0, {80.0, 200.0})};
  std::size_t last_done = 0;
  Context context = test::context;
  context.threads = 1;
  const SkyTable one = fit_table(context, skies, TableFitOptions::half_floats());
  context.threads = 3;
  context.progress = [&](std::string_view stage, std::size_t done, std::size_t all) {
    EXPECT_EQ(stage, "fitting");
    EXPECT_EQ(all, 3u);
    EXPECT_EQ(done, ++last_done);
  };
  const SkyTable three = fit_table(context, skies, TableFitOptions::half_floats());
  EXPECT_EQ(one.entries, three.entries);
  EXPECT_EQ(last_done, 3u);
}

TEST(FitTable, ASkyThatCannotBeFittedIsNamedByItsRow) {
  std::vector<TableSky> skies = kTwoSkies;
  skies[1].fitted.colour[17].Y = 0.0;
  try {
    fit_table(test::context, skies, TableFitOptions::half_floats());
    FAIL() << "a black direction has no relative residual";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("row 2 (altitude 12 km, turbidity 0.5, sun 45:90): "), 0u);
  }
}

}  // namespace
}  // namespace skylut
