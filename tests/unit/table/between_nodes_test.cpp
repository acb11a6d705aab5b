#include "skylut/table/between_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "skylut/models/preetham_coefficients.hpp"

namespace skylut {
namespace {

TableEntry row(double altitude_km, double zenith_kcd_m2) {
  const PerezYxy c = preetham1999_coefficients(3.0);
  TableEntry entry;
  entry.altitude_km = altitude_km;
  entry.turbidity = 0.1;
  entry.sun = {50.0, 0.0};
  entry.Y = c.Y;
  entry.x = c.x;
  entry.y = c.y;
  entry.zenith = {zenith_kcd_m2, 0.25, 0.26};
  return entry;
}

// The truth at 1 km is a row's sky whose zenith is `truth` kcd/m², the row alone is 5 % brighter.
HeldOutSky held_out(double truth) {
  HeldOutSky sky;
  sky.directions = {{0.0, 0.0}, {40.0, 90.0}, {80.0, 10.0}};
  sky.solid_angles_sr = {1.0, 2.0, 5.0};
  sky.colours.resize(3);
  sky_of(row(1.0, truth)).colour(sky.directions, sky.colours);
  sky.alone = row(1.0, 1.05 * truth);
  return sky;
}

// Between zeniths of 4 and 1 kcd/m² the table has 2: that is the error, at every direction.
TEST(BetweenNodes, ErrorsAreThoseOfTheBlend) {
  const TableModel table(Table({row(0.0, 4.0), row(2.0, 1.0)}));
  const std::vector<HeldOutSky> skies{held_out(2.0), held_out(2.0 / 1.5), held_out(2.0 / 1.06)};
  const BetweenNodesError error = between_nodes_error(table, skies);
  EXPECT_EQ(error.skies, 3u);
  EXPECT_NEAR(error.Y.median, 0.06, 1e-9);
  EXPECT_NEAR(error.Y.worst, 0.5, 1e-9);
  EXPECT_NEAR(error.Y_alone.worst, 0.05, 1e-9);
  EXPECT_NEAR(error.x.worst, 0.0, 1e-12);
  EXPECT_EQ(error.close, 2u);  // 0 and 0.06 are at most 1.2 × 0.05 + 0.01
  EXPECT_EQ(error.worst_of_Y.altitude_km, 1.0);
  const auto json = between_nodes_json(table, skies);
  EXPECT_EQ(json["sun_up"]["table"]["Y"]["worst"], error.Y.worst);
  EXPECT_FALSE(json.contains("sun_below_horizon"));
}

TEST(HeldOut, ConditionsAreSpreadOverTheDomain) {
  ModelInfo domain;
  domain.altitude_km = {0.0, 30.0, "km"};
  domain.turbidity = {0.0, 1.0, ""};
  domain.sun_zenith_deg = {0.0, 96.0, "deg"};
  const auto all = held_out_conditions(domain);
  ASSERT_EQ(all.size(), 8u);
  std::set<double> loads;
  double altitudes_km = 0.0;
  for (const HeldOutConditions& one : all) {
    EXPECT_GT(one.turbidity, 0.0);
    EXPECT_LT(one.turbidity, 1.0);
    loads.insert(one.turbidity);
    for (const double altitude_km : one.altitudes_km) altitudes_km += altitude_km / 40.0;
    std::set<int> fifths;  // of the way to the horizon; 5: below it
    for (const double sun_deg : one.sun_zeniths_deg) fifths.insert(static_cast<int>(sun_deg / 18.0));
    EXPECT_EQ(fifths.size(), 6u);
    EXPECT_EQ(one.sun_zeniths_deg.size(), 7u);
  }
  EXPECT_EQ(loads.size(), 8u);
  EXPECT_NEAR(altitudes_km, 15.0, 1.0);
  domain.altitude_km = {6.0, 6.0, "km"};
  EXPECT_EQ(held_out_conditions(domain).front().altitudes_km, std::vector<double>{6.0});
}

}  // namespace
}  // namespace skylut
