#include "skylut/table/table_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "skylut/core/version.hpp"
#include "support/test_context.hpp"
#include "test_maps.hpp"

namespace skylut {
namespace {

SkyScene scene() {
  SkyScene scene;
  scene.profile = load_profile(test::context, "ussa1976");
  scene.air.ground_albedo = 0.15;
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.5}};
  scene.suns = {{60.0, 90.0}};
  scene.directions = directions_utm271();
  return scene;
}

std::string text() {
  const std::vector<SkyMap> maps{perez_map(0.0, {60.0, 90.0})};
  const TableOrigin origin{"skylut table --albedo 0.15", "draft", "uniform", "utm271",
                           Place{48.0, 2.0, 35.0}};
  return table_json(test::context, fit_table(test::context, maps, {}), scene(), origin);
}

TEST(TableJson, HoldsEveryInput) {
  const auto file = nlohmann::json::parse(text());
  EXPECT_EQ(file["format"], "skylut table");
  EXPECT_EQ(file["skylut_version"], kVersion);
  EXPECT_EQ(file["command"], "skylut table --albedo 0.15");
  const auto& inputs = file["inputs"];
  EXPECT_EQ(inputs["altitudes_km"], nlohmann::json::array({0.0}));
  EXPECT_EQ(inputs["turbidities"][0]["kind"], "aod500");
  EXPECT_EQ(inputs["turbidities"][0]["given"], 0.5);
  EXPECT_GT(inputs["turbidities"][0]["preetham-t"], 1.0);
  EXPECT_EQ(inputs["suns"][0]["zenith_deg"], 60.0);
  EXPECT_EQ(inputs["directions"]["count"], 271);
  EXPECT_EQ(inputs["wavelengths_nm"]["step"], 5.0);
  EXPECT_EQ(inputs["quality"], "draft");
  EXPECT_EQ(inputs["weights"], "uniform");
  EXPECT_EQ(inputs["air"]["ground_albedo"], 0.15);
  EXPECT_EQ(inputs["air"]["place"]["latitude_deg"], 48.0);
  // The profile's own ozone is written out: no atmosphere has less than 100 or more than 600 DU.
  EXPECT_GT(inputs["air"]["ozone_du"], 100.0);
  EXPECT_LT(inputs["air"]["ozone_du"], 600.0);
  EXPECT_EQ(inputs["profile"]["name"], "ussa1976");
  EXPECT_EQ(inputs["profile"]["altitude_km"].size(), inputs["profile"]["temperature_K"].size());
}

TEST(TableJson, HoldsTheReportOfEveryFit) {
  const auto row = nlohmann::json::parse(text())["rows"][0];
  EXPECT_EQ(row["row"], 1);
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
    EXPECT_TRUE(report["worst_direction"].contains("zenith_deg"));
  }
}

TEST(TableJson, SameTableSameBytes) { EXPECT_EQ(text(), text()); }

}  // namespace
}  // namespace skylut
