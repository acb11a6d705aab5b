#include "skylut/table/table_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skylut/core/version.hpp"
#include "support/test_context.hpp"
#include "test_maps.hpp"

namespace skylut {
namespace {

const std::vector<TableSky> kSkies{perez_table_sky(0.0, {60.0, 90.0})};

std::string text() {
  Provenance provenance("skylut table --albedo 0.15");
  provenance.describe("weights", std::string("uniform"));
  return table_json(fit_table(test::context, kSkies, TableFitOptions::half_floats()), provenance);
}

TEST(TableJson, SaysHowItCameAbout) {
  const auto file = nlohmann::json::parse(text());
  EXPECT_EQ(file["format"], "skylut table");
  EXPECT_EQ(file["skylut_version"], kVersion);
  EXPECT_EQ(file["command"], "skylut table --albedo 0.15");
  EXPECT_EQ(file["inputs"]["weights"], "uniform");
}

TEST(TableJson, HoldsTheReportOfEveryFit) {
  const auto row = nlohmann::json::parse(text())["rows"][0];
  EXPECT_EQ(row["row"], 1);
  EXPECT_EQ(row["horizon_zenith_deg"], 90.0);
  EXPECT_EQ(row["light_below_90"], 0.0);
  EXPECT_NEAR(row["zenith"]["Y"].get<double>(), 3.5, 1e-12);
  for (const char* channel : {"Y", "x", "y"}) {
    const auto& report = row[channel];
    for (const char* name : kPerezNames) {
      EXPECT_TRUE(report["coefficients"][name].is_number());
      EXPECT_TRUE(report["standard_errors"].contains(name));
      EXPECT_TRUE(report["determined"][name].is_boolean());
      EXPECT_TRUE(report["at_bound"][name].is_boolean());
    }
    EXPECT_EQ(report["termination"], "converged");
    EXPECT_LT(report["rmse"].get<double>(), 1e-6);
    EXPECT_LT(report["rmse_horizon"].get<double>(), 1e-6);
    EXPECT_EQ(report["cost_over_least"], 0.0);
    EXPECT_LT(report["fit_rmse"].get<double>(), 1e-6);
    EXPECT_TRUE(report["worst_direction"].contains("zenith_deg"));
  }
}

}  // namespace
}  // namespace skylut
