#include "skylut/table/table_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/preetham_coefficients.hpp"

namespace skylut {
namespace {

// Preetham's coefficients, whose T grows with the load; a zenith that falls with height and the sun.
TableEntry preetham_row(double altitude_km, double turbidity, double sun_zenith_deg) {
  const PerezYxy c = preetham1999_coefficients(2.0 + 2.0 * turbidity);
  TableEntry entry;
  entry.altitude_km = altitude_km;
  entry.turbidity = turbidity;
  entry.sun = {sun_zenith_deg, 90.0};
  entry.Y = c.Y;
  entry.x = c.x;
  entry.y = c.y;
  entry.zenith = {(4.0 + turbidity) * std::exp(-altitude_km / 8.0 - sun_zenith_deg / 40.0),
                  0.25 + 0.02 * turbidity, 0.26 + 0.02 * turbidity};
  return entry;
}

const std::vector<double> kAltitudes_km{0.0, 2.0, 6.0, 12.0, 20.0};
const std::vector<double> kTurbidities{0.0, 0.25, 1.0};
const std::vector<double> kSuns_deg{2.0, 30.0, 60.0, 90.0};

using Change = std::function<void(TableEntry&)>;

TableModel grid_model(
    const TableModelOptions& options = {}, const Change& change = [](TableEntry&) {}) {
  std::vector<TableEntry> rows;
  for (const double altitude_km : kAltitudes_km)
    for (const double turbidity : kTurbidities)
      for (const double sun_deg : kSuns_deg) {
        rows.push_back(preetham_row(altitude_km, turbidity, sun_deg));
        change(rows.back());
      }
  return TableModel(Table(rows), options);
}

std::vector<Direction> dome() {
  std::vector<Direction> views{{0.0, 0.0}};
  for (double zenith_deg = 7.5; zenith_deg <= 90.0; zenith_deg += 7.5)
    for (double azimuth_deg = 0.0; azimuth_deg < 360.0; azimuth_deg += 15.0)
      views.push_back({zenith_deg, azimuth_deg});
  return views;
}

std::vector<Yxy> colours_at(const TableModel& model, const SkyConditions& conditions) {
  const std::vector<Direction> views = dome();
  std::vector<Yxy> colours(views.size());
  model.at(conditions)->colour(views, colours);
  return colours;
}

double largest_difference(const std::vector<Yxy>& a, const std::vector<Yxy>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max({largest, std::abs(a[i].Y / b[i].Y - 1.0), std::abs(a[i].x / b[i].x - 1.0),
                        std::abs(a[i].y / b[i].y - 1.0)});
  return largest;
}

std::string refusal(const TableModel& model, const SkyConditions& conditions) {
  try {
    model.at(conditions);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

SkyConditions conditions(double altitude_km, double aod500, const Direction& sun) {
  return {.altitude_km = altitude_km, .turbidity = {TurbidityKind::aod500, aod500}, .sun = sun};
}

TEST(TableModel, IsTheFormulaAtItsNodesWhateverTheAzimuth) {
  const TableModel model = grid_model();
  for (const double altitude_km : kAltitudes_km)
    for (const double turbidity : kTurbidities)
      for (const double sun_deg : kSuns_deg)
        for (const double azimuth_deg : {90.0, 200.0}) {
          const Direction sun{sun_deg, azimuth_deg};
          const TableEntry row = preetham_row(altitude_km, turbidity, sun_deg);
          std::vector<Yxy> expected;
          for (const Direction& view : dome()) {
            expected.push_back(perez_sky(row.Y, row.x, row.y, row.zenith, view.zenith_deg * kRadiansPerDegree,
                                         angle_between(view, sun), sun_deg * kRadiansPerDegree));
            expected.back().Y *= 1000.0;
          }
          EXPECT_TRUE(model.is_node(conditions(altitude_km, turbidity, sun)));
          EXPECT_LT(largest_difference(colours_at(model, conditions(altitude_km, turbidity, sun)), expected),
                    1e-12);
        }
}

TEST(TableModel, IsContinuousWhereTheRowsAroundChange) {
  for (const TableRule rule : {TableRule::blend, TableRule::utm2005}) {
    const TableModel model = grid_model({.rule = rule});
    const SkyConditions node = conditions(6.0, 0.25, {60.0, 90.0});
    const std::vector<Yxy> there = colours_at(model, node);
    for (const double step : {-1e-9, 1e-9}) {
      SkyConditions beside = node;
      beside.altitude_km += step;
      beside.turbidity.value += step;
      beside.sun.zenith_deg += step;
      EXPECT_FALSE(model.is_node(beside));
      EXPECT_LT(largest_difference(colours_at(model, beside), there), 1e-7);
    }
  }
}

// Rows that differ by a factor: between them its powers, by altitude, by the root of the load, by the sun.
TEST(TableModel, BlendsLogarithmsAlongSmoothAxes) {
  const auto doubling = [](double TableEntry::*axis, double upper) {
    return [=](TableEntry& row) {
      const double at = row.*axis;
      row = preetham_row(0.0, 0.0, 60.0);
      row.*axis = at;
      row.zenith = {at >= upper ? 2.0 : 1.0, at >= upper ? 0.36 : 0.25, 0.3};
    };
  };
  std::vector<TableEntry> rows{preetham_row(2.0, 0.0, 60.0), preetham_row(6.0, 0.0, 60.0)};
  for (TableEntry& row : rows) doubling(&TableEntry::altitude_km, 6.0)(row);
  const Yxy aloft = TableModel(Table(rows)).at(conditions(3.0, 0.0, {60.0, 0.0}))->colour(Direction{});
  EXPECT_NEAR(aloft.Y, 1000.0 * std::pow(2.0, 0.25), 1e-9);
  EXPECT_NEAR(aloft.x, 0.25 * std::pow(0.36 / 0.25, 0.25), 1e-12);

  rows = {preetham_row(0.0, 0.0, 60.0), preetham_row(0.0, 1.0, 60.0)};
  for (TableEntry& row : rows) doubling(&TableEntry::turbidity, 1.0)(row);
  const Yxy hazy = TableModel(Table(rows)).at(conditions(0.0, 0.25, {60.0, 0.0}))->colour(Direction{});
  EXPECT_NEAR(hazy.Y, 1000.0 * std::sqrt(2.0), 1e-9);
}

// The brightest direction is the sun's own, between rows whose aureoles stand 30 deg apart.
TEST(TableModel, TheAureoleGoesWithTheSun) {
  const TableModel model = grid_model({}, [](TableEntry& row) { row.Y = {-1.0, -0.3, 40.0, -20.0, 0.2}; });
  const auto sky = model.at(conditions(0.0, 0.0, {45.0, 90.0}));
  double brightest = 0.0;
  double where_deg = 0.0;
  for (double zenith_deg = 1.0; zenith_deg < 90.0; zenith_deg += 1.0)
    if (const double Y = sky->colour(Direction{zenith_deg, 90.0}).Y; Y > brightest) {
      brightest = Y;
      where_deg = zenith_deg;
    }
  EXPECT_EQ(where_deg, 45.0);
}

TEST(TableModel, LightOfPositiveRowsLiesBetweenThem) {
  const TableModel model = grid_model();
  const std::vector<Yxy> low = colours_at(model, conditions(2.0, 0.25, {60.0, 90.0}));
  const std::vector<Yxy> high = colours_at(model, conditions(6.0, 0.25, {60.0, 90.0}));
  const std::vector<Yxy> between = colours_at(model, conditions(3.7, 0.25, {60.0, 90.0}));
  for (std::size_t i = 0; i < between.size(); ++i) {
    EXPECT_LT(between[i].Y, low[i].Y);
    EXPECT_GT(between[i].Y, high[i].Y);
  }
}

TEST(TableModel, MirrorImagesAreEqual) {
  const auto sky = grid_model().at(conditions(3.0, 0.1, {50.0, 130.0}));
  for (const double from_sun_deg : {10.0, 77.0, 179.0})
    EXPECT_DOUBLE_EQ(sky->colour(Direction{70.0, 130.0 + from_sun_deg}).Y,
                     sky->colour(Direction{70.0, 130.0 - from_sun_deg}).Y);
}

// Below the lowest sun its row and the mirror image of it are the neighbours, and both are the same formula.
TEST(TableModel, TheSunMayStandAtTheZenith) {
  const TableModel model = grid_model();
  EXPECT_EQ(model.info().sun_zenith_deg.lowest, 0.0);
  const auto sky = model.at(conditions(0.0, 0.0, {0.0, 0.0}));
  const TableEntry row = preetham_row(0.0, 0.0, 2.0);
  const double scale = 1000.0 * row.zenith.Y / perez(row.Y, 0.0, 2.0 * kRadiansPerDegree);
  for (const double azimuth_deg : {0.0, 100.0}) {
    const double view_rad = 40.0 * kRadiansPerDegree;
    EXPECT_NEAR(sky->colour(Direction{40.0, azimuth_deg}).Y, scale * perez(row.Y, view_rad, view_rad), 1e-8);
  }
  EXPECT_EQ(
      grid_model({}, [](TableEntry& row_of) { row_of.sun.zenith_deg += 8.0; }).info().sun_zenith_deg.lowest,
      10.0);
}

TEST(TableModel, RefusesWhatIsOutsideUnlessItExtrapolates) {
  const SkyConditions above = conditions(25.0, 0.25, {60.0, 90.0});
  EXPECT_EQ(refusal(grid_model(), above), "altitude 25 km (0 to 20 km): must lie within what the table has");
  const std::string all = refusal(grid_model(), conditions(25.0, 1.5, {95.0, 90.0}));
  EXPECT_NE(all.find("turbidity (aod500) 1.5 (0 to 1), sun zenith angle 95 deg (0 to 90 deg)"),
            std::string::npos)
      << all;
  const TableModel insisting = grid_model({.extrapolate = true});
  EXPECT_LT(largest_difference(colours_at(insisting, above),
                               colours_at(insisting, conditions(20.0, 0.25, {60.0, 90.0}))),
            1e-12);
}

TEST(TableModel, RowsThatDoNotFillAGridAreAllThereIs) {
  const TableModel model(Table({preetham_row(0.0, 0.0, 30.0), preetham_row(6.0, 0.0, 60.0)}));
  EXPECT_EQ(refusal(model, conditions(6.0, 0.0, {60.0, 90.0})), "no error");
  EXPECT_NE(refusal(model, conditions(3.0, 0.0, {40.0, 90.0})).find("must be those of a row"),
            std::string::npos);
  EXPECT_NE(refusal(model, conditions(0.0, 0.0, {60.0, 90.0})).find("altitudes 0, 6 km"), std::string::npos);
}

// A view below the horizon, and a formula that is infinite at it.
TEST(TableModel, RefusesViewsThatTheRowsHaveNothingFor) {
  const SkyConditions between = conditions(3.0, 0.1, {50.0, 130.0});
  EXPECT_THROW(grid_model().at(between)->colour(Direction{91.0, 0.0}), InputError);
  const auto infinite = grid_model({}, [](TableEntry& row) { row.Y.B = 0.1; }).at(between);
  EXPECT_GT(infinite->colour(Direction{89.0, 0.0}).Y, 0.0);
  EXPECT_THROW(infinite->colour(Direction{90.0, 0.0}), InputError);
}

// Where a row is negative there is no logarithm: the straight mean.
TEST(TableModel, NegativeRowsAreBlendedAsTheyAre) {
  std::vector<TableEntry> rows{preetham_row(0.0, 0.0, 60.0), preetham_row(2.0, 0.0, 60.0)};
  rows[0].zenith.x = -0.1;
  rows[1].zenith.x = 0.3;
  const Yxy colour = TableModel(Table(rows)).at(conditions(1.0, 0.0, {60.0, 0.0}))->colour(Direction{});
  EXPECT_NEAR(colour.x, 0.1, 1e-12);
}

// Lagrange's cubic gives back a cubic of the altitude in Y, x and y, from whichever four altitudes.
TEST(TableModel, UtmRuleIsExactForACubic) {
  const auto cubic = [](double z) { return 5.0 - 0.3 * z + 0.02 * z * z - 0.0004 * z * z * z; };
  const TableModel model = grid_model({.rule = TableRule::utm2005}, [&](TableEntry& row) {
    row.zenith = {cubic(row.altitude_km), 0.05 * cubic(row.altitude_km), 0.3};
  });
  for (const double altitude_km : {0.5, 3.0, 9.0, 19.0}) {
    const Yxy colour = model.at(conditions(altitude_km, 0.25, {60.0, 0.0}))->colour(Direction{});
    EXPECT_NEAR(colour.Y, 1000.0 * cubic(altitude_km), 1e-8);
    EXPECT_NEAR(colour.x, 0.05 * cubic(altitude_km), 1e-12);
  }
}

// Of five altitudes the two on either side: at 9 km the row on the ground does not matter, at 3 km that
// at 20.
TEST(TableModel, UtmRuleTakesTheAltitudesAround) {
  const auto brighter_at = [](double altitude_km) {
    return grid_model({.rule = TableRule::utm2005}, [=](TableEntry& row) {
      if (row.altitude_km == altitude_km) row.zenith.Y *= 2.0;
    });
  };
  const auto zenith = [](const TableModel& model, double altitude_km) {
    return model.at(conditions(altitude_km, 0.25, {60.0, 0.0}))->colour(Direction{}).Y;
  };
  EXPECT_EQ(zenith(brighter_at(0.0), 9.0), zenith(brighter_at(-1.0), 9.0));
  EXPECT_NE(zenith(brighter_at(20.0), 9.0), zenith(brighter_at(-1.0), 9.0));
  EXPECT_EQ(zenith(brighter_at(20.0), 3.0), zenith(brighter_at(-1.0), 3.0));
  EXPECT_NE(zenith(brighter_at(0.0), 3.0), zenith(brighter_at(-1.0), 3.0));
}

TEST(TableModel, UtmRuleNeedsFourAltitudes) {
  const TableModel model(Table({preetham_row(0.0, 0.0, 60.0), preetham_row(6.0, 0.0, 60.0)}),
                         {.rule = TableRule::utm2005});
  EXPECT_NE(refusal(model, conditions(3.0, 0.0, {60.0, 0.0})).find("at least 4 altitudes"),
            std::string::npos);
}

}  // namespace
}  // namespace skylut
