#include "skylut/table/fit_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(FitTable, KnownSkiesComeBackInTheirRows) {
  const std::vector<SkyMap> maps{perez_map(0.0, {60.0, 90.0}), perez_map(12.0, {45.0, 90.0})};
  const SkyTable table = fit_table(test::context, maps, {});
  ASSERT_EQ(table.entries.size(), 2u);
  ASSERT_EQ(table.fits.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    const TableEntry& entry = table.entries[row];
    EXPECT_EQ(entry.altitude_km, maps[row].altitude_km);
    EXPECT_EQ(entry.turbidity, 0.5);
    EXPECT_EQ(entry.sun, maps[row].sun);
    EXPECT_NEAR(entry.zenith.Y, 3.5, 1e-12);  // kcd/m² from cd/m²
    EXPECT_NEAR(entry.zenith.x, 0.25, 1e-12);
    expect_near(entry.Y, kMadeUp_Y);
    expect_near(entry.x, kMadeUp_x);
    expect_near(entry.y, kMadeUp_y);
    EXPECT_LT(entry.rmse_Y_rel, 1e-8);
  }
}

// A sky and its image in the sun's vertical plane are equal samples: fitted once, the image's worst direction
// is the mirrored one, not the same index.
TEST(FitTable, MirrorImagesHaveMirroredWorstDirections) {
  const Direction sun{60.0, 90.0};
  std::vector<SkyMap> maps{perez_map(0.0, sun), perez_map(0.0, sun)};
  const auto index_of = [&](double zenith_deg, double azimuth_deg) {
    const auto& directions = maps[0].directions;
    const Direction wanted{zenith_deg, zenith_deg == 0.0 ? 0.0 : azimuth_deg};
    return static_cast<std::size_t>(std::find(directions.begin(), directions.end(), wanted) -
                                    directions.begin());
  };
  maps[0].colour[index_of(40.0, 24.0)].Y *= 1.2;
  for (std::size_t i = 0; i < maps[0].directions.size(); ++i) {
    const auto& [zenith_deg, azimuth_deg] = maps[0].directions[i];
    maps[1].colour[index_of(zenith_deg, std::fmod(540.0 - azimuth_deg, 360.0))] = maps[0].colour[i];
  }
  Context context = test::context;
  std::size_t fitted = 0;
  context.progress = [&](std::string_view, std::size_t, std::size_t) { ++fitted; };
  const SkyTable table = fit_table(context, maps, {});
  EXPECT_EQ(fitted, 1u);
  EXPECT_EQ(table.fits[0].Y.worst_direction, index_of(40.0, 24.0));
  EXPECT_EQ(table.fits[1].Y.worst_direction, index_of(40.0, 156.0));
  EXPECT_EQ(table.fits[0].Y.worst_residual, table.fits[1].Y.worst_residual);
}

TEST(FitTable, NamesTheRowsThatDidNotConverge) {
  const std::vector<SkyMap> maps{perez_map(0.0, {60.0, 90.0}), perez_map(12.0, {45.0, 90.0})};
  SkyTable table = fit_table(test::context, maps, {});
  EXPECT_NO_THROW(require_converged(table));
  table.fits[1].x.termination = Termination::no_convergence;
  try {
    require_converged(table);
    FAIL() << "row 2 did not converge";
  } catch (const WorkError& error) {
    EXPECT_NE(std::string(error.what()).find("rows 2 (x)"), std::string::npos);
  }
}

TEST(FitTable, ThreadsChangeNothing) {
  const std::vector<SkyMap> maps{perez_map(0.0, {60.0, 90.0}), perez_map(6.0, {30.0, 0.0}),
                                 perez_map(12.0, {80.0, 200.0})};
  std::size_t last_done = 0;
  Context context = test::context;
  context.threads = 1;
  const SkyTable one = fit_table(context, maps, {});
  context.threads = 3;
  context.progress = [&](std::string_view stage, std::size_t done, std::size_t all) {
    EXPECT_EQ(stage, "fitting");
    EXPECT_EQ(all, 3u);
    EXPECT_EQ(done, ++last_done);
  };
  const SkyTable three = fit_table(context, maps, {});
  EXPECT_EQ(one.entries, three.entries);
  EXPECT_EQ(last_done, 3u);
}

TEST(FitTable, ASkyThatCannotBeFittedIsNamedByItsRow) {
  std::vector<SkyMap> maps{perez_map(0.0, {60.0, 90.0}), perez_map(12.0, {45.0, 90.0})};
  maps[1].colour[17].Y = 0.0;
  try {
    fit_table(test::context, maps, {});
    FAIL() << "a black direction has no relative residual";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("row 2 (altitude 12 km, turbidity 0.5, sun 45:90): "), 0u);
  }
}

}  // namespace
}  // namespace skylut
