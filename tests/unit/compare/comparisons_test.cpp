#include "skylut/compare/comparisons.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/utm2005.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

constexpr double kT = 3.0;

// A row whose zenith is Preetham's, `brighter` times as bright.
TableEntry preetham_entry(double altitude_km, double T, const Direction& sun, double brighter) {
  const PerezYxy k = preetham1999_coefficients(T);
  TableEntry entry;
  entry.altitude_km = altitude_km;
  entry.turbidity = T;
  entry.sun = sun;
  entry.Y = k.Y;
  entry.x = k.x;
  entry.y = k.y;
  entry.zenith = preetham1999_zenith_kcd_m2(T, sun.zenith_deg * kRadiansPerDegree);
  entry.zenith.Y *= brighter;
  entry.zenith.x += 0.01;
  return entry;
}

nlohmann::json rows_of(const CompareReport& report) {
  return nlohmann::json::parse(report.json(Provenance()))["rows"];
}

TEST(Comparisons, ATableOfThePublishedModelDiffersByWhatWasPutIn) {
  const Table table({preetham_entry(0.0, kT, {45.0, 90.0}, 1.1), preetham_entry(0.0, kT, {95.0, 90.0}, 1.0),
                     preetham_entry(6.0, kT, {45.0, 90.0}, 1.0)},
                    TurbidityKind::preetham_t);
  const CompareReport report = compare_table(test::context, table, "preetham1999");
  const auto rows = rows_of(report);
  ASSERT_EQ(rows.size(), 1u);  // neither below the horizon nor above the ground
  const auto& row = rows[0];
  EXPECT_EQ(row["range"], "in range");
  EXPECT_EQ(row["preetham_t"], kT);
  EXPECT_NEAR(row["rmse_Y_rel"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(row["mean_Y_rel"].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(row["rmse_y"].get<double>(), 0.0);
  EXPECT_GT(row["rmse_x"].get<double>(), 0.005);  // 0.01 at the zenith, scaled elsewhere
  EXPECT_NEAR(row["Y_zenith_kcd_m2"].get<double>() / row["Y_zenith_kcd_m2_preetham1999"].get<double>(), 1.1,
              1e-12);
  EXPECT_EQ(row["A_Y"], row["A_Y_preetham1999"]);
  EXPECT_NE(report.notes.back().find("2 rows left out"), std::string::npos);
}

TEST(Comparisons, SaysWhereTheModelGivesNothing) {
  const Table table(
      {preetham_entry(0.0, 1.1, {45.0, 90.0}, 1.0), preetham_entry(0.0, 8.0, {45.0, 90.0}, 1.0)},
      TurbidityKind::preetham_t);
  const auto rows = rows_of(compare_table(test::context, table, "preetham1999"));
  EXPECT_EQ(rows[0]["range"].get<std::string>().find("preetham-t below 2, view at the horizon"), 0u);
  EXPECT_TRUE(rows[0]["rmse_Y_rel"].is_null());
  EXPECT_EQ(rows[1]["range"], "preetham-t above 6");
  EXPECT_TRUE(rows[1]["rmse_Y_rel"].is_number());
}

// Every row has the header's number of cells, and a text with commas is one cell.
TEST(Comparisons, CsvIsRectangular) {
  const Table table({preetham_entry(0.0, 1.1, {45.0, 90.0}, 1.0)}, TurbidityKind::preetham_t);
  for (const std::string& name : comparison_names()) {
    std::istringstream csv(compare_table(test::context, table, name).csv(Provenance("skylut compare")));
    std::size_t columns = 0;
    for (std::string line; std::getline(csv, line);) {
      if (line[0] == '#') continue;
      std::size_t commas = 0;
      bool quoted = false;
      for (const char character : line) {
        if (character == '"') quoted = !quoted;
        if (character == ',' && !quoted) ++commas;
      }
      if (columns == 0) columns = commas;
      EXPECT_EQ(commas, columns) << name << ": " << line;
    }
    EXPECT_GT(columns, 10u);
  }
}

TEST(Comparisons, Utm2005FindsTheSameRow) {
  const Utm2005Row published = load_utm2005(test::context).back();
  TableEntry ours = preetham_entry(published.altitude_km, kT, published.sun, 1.0);
  ours.turbidity = published.turbidity;
  const auto rows = rows_of(compare_table(test::context, Table({ours}), "utm2005"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool same = i + 1 == rows.size();
    EXPECT_EQ(rows[i]["A_Y"].is_number(), same) << i;
    EXPECT_EQ(rows[i]["Y_zenith_kcd_m2"].is_number(), same) << i;
    EXPECT_TRUE(rows[i]["A_utm2005"].is_number());
  }
  EXPECT_EQ(rows.back()["A_Y"], ours.Y.A);
  EXPECT_EQ(rows.back()["A_utm2005"], published.coefficients.A);
}

TEST(Comparisons, RefusesWhatCannotBeCompared) {
  const Table high({preetham_entry(6.0, kT, {45.0, 90.0}, 1.0)}, TurbidityKind::preetham_t);
  EXPECT_THROW(compare_table(test::context, high, "preetham1999"), InputError);
  EXPECT_THROW(compare_table(test::context, high, "nishita"), InputError);
}

}  // namespace
}  // namespace skylut
