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
  sky.solid_angles = {1.0, 2.0, 5.0};
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
  EXPECT_EQ(between_nodes_json(error)["table"]["Y"]["worst"], error.Y.worst);
}

TEST(BetweenNodes, HeldOutConditionsAreSpreadOverTheBox) {
  const auto conditions =
      held_out_conditions({0.0, 30.0, "km"}, TurbidityKind::aod500, {0.0, 1.0, ""}, {0.0, 90.0, "deg"}, 8, 5);
  ASSERT_EQ(conditions.size(), 40u);
  std::set<double> loads;
  std::set<int> fifths;
  double altitudes = 0.0;
  for (const SkyConditions& one : conditions) {
    loads.insert(one.turbidity.value);
    fifths.insert(static_cast<int>(one.sun.zenith_deg / 18.0));
    altitudes += one.altitude_km;
    EXPECT_GT(one.turbidity.value, 0.0);
    EXPECT_LT(one.sun.zenith_deg, 90.0);
  }
  EXPECT_EQ(loads.size(), 8u);
  EXPECT_EQ(fifths.size(), 5u);
  EXPECT_NEAR(altitudes / 40.0, 15.0, 1.0);
}

}  // namespace
}  // namespace skylut
