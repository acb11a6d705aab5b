#include "zenith_panel.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "horizon.hpp"
#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

constexpr double kPlanet_km = 6371.0;
const std::vector<double> kLevels_km{0.0, 0.25, 1.0, 2.0, 5.0, 12.0, 40.0, 100.0};

// Panels follow each other from the zenith to the nadir; only at the horizon is there a hair between them.
TEST(ZenithPanels, CoverTheSphere) {
  for (const double observer_km : {0.0, 0.03, 3.0, 12.0, 30.0}) {
    const std::vector<ZenithPanel> panels = zenith_panels(kLevels_km, observer_km, kPlanet_km);
    EXPECT_NEAR(panels.front().lowest_zenith_deg(), 0.0, 1e-12);
    EXPECT_NEAR(panels.back().highest_zenith_deg(), 180.0, 1e-9);
    for (std::size_t i = 0; i + 1 < panels.size(); ++i)
      EXPECT_NEAR(panels[i].highest_zenith_deg(), panels[i + 1].lowest_zenith_deg(), 2e-3)
          << observer_km << " km, panel " << i;
  }
}

TEST(ZenithPanels, CoordinatesGoBothWays) {
  for (const double observer_km : {0.0, 3.0, 30.0})
    for (const ZenithPanel& panel : zenith_panels(kLevels_km, observer_km, kPlanet_km)) {
      for (const double x : {-0.9, -0.3, 0.2, 0.95})
        EXPECT_NEAR(panel.coordinate(panel.zenith_deg(x)), x, 1e-5);
      const std::vector<ZenithPanel> halves = panel.halves();
      EXPECT_NEAR(halves[0].zenith_deg(-1.0), panel.zenith_deg(-1.0), 1e-12);
      EXPECT_NEAR(halves[0].zenith_deg(1.0), panel.zenith_deg(0.0), 1e-12);
      EXPECT_NEAR(halves[1].zenith_deg(1.0), panel.zenith_deg(1.0), 1e-12);
    }
}

// The one panel of a dome is even in ln(1 + e/1.5°), that of a limb ends a hair above the ground.
TEST(ZenithPanels, OfAWholeDomeAndLimb) {
  const ZenithPanel dome = ZenithPanel::whole_dome(3.0, kPlanet_km);
  EXPECT_EQ(dome.lowest_zenith_deg(), 0.0);
  EXPECT_EQ(dome.highest_zenith_deg(), 90.0);
  EXPECT_NEAR(dome.zenith_deg(0.0), 90.0 - 1.5 * (std::sqrt(61.0) - 1.0), 1e-12);
  const ZenithPanel limb = ZenithPanel::whole_limb(3.0, kPlanet_km);
  EXPECT_NEAR(limb.lowest_zenith_deg(), 90.0, 1e-12);
  EXPECT_NEAR(limb.highest_zenith_deg(), horizon_zenith_deg(kPlanet_km, 3.0), 1e-5);
  EXPECT_LT(limb.highest_zenith_deg(), horizon_zenith_deg(kPlanet_km, 3.0));
  for (const ZenithPanel& panel : {dome, limb})
    for (const double x : {-0.9, -0.3, 0.2, 0.95})
      EXPECT_NEAR(panel.coordinate(panel.zenith_deg(x)), x, 1e-9);
}

// Between the horizontal and the horizon a panel ends where a line of sight touches a level: at the zenith
// angle whose sine is (R + level)/(R + observer).
TEST(ZenithPanels, LimbPanelsEndAtTheLevels) {
  const double observer_km = 12.0;
  std::vector<double> expected;
  for (const double level_km : {5.0, 2.0, 1.0, 0.25})
    expected.push_back(180.0 -
                       std::asin((kPlanet_km + level_km) / (kPlanet_km + observer_km)) * kDegreesPerRadian);
  std::vector<double> ends;
  for (const ZenithPanel& panel : zenith_panels(kLevels_km, observer_km, kPlanet_km))
    if (panel.kind() == ZenithPanel::Kind::limb) ends.push_back(panel.highest_zenith_deg());
  ASSERT_EQ(ends.size(), expected.size() + 1);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(ends[i], expected[i], 1e-9);
  EXPECT_NEAR(ends.back(), horizon_zenith_deg(kPlanet_km, observer_km), 1e-6);
}

// Through n points goes one polynomial of degree n - 1.
TEST(Lobatto, PolynomialsAreExact) {
  const std::vector<double> points = lobatto_points(6);
  const auto polynomial = [](double x) {
    return ((((2.0 * x - 1.0) * x + 3.0) * x - 4.0) * x + 0.5) * x - 7.0;
  };
  std::vector<double> weights(6);
  for (const double x : {-1.0, -0.83, 0.0, 0.4, points[4], 1.0}) {
    lobatto_weights(x, points, weights);
    double sum = 0.0;
    for (std::size_t j = 0; j < 6; ++j) sum += weights[j] * polynomial(points[j]);
    EXPECT_NEAR(sum, polynomial(x), 1e-12) << x;
  }
}

}  // namespace
}  // namespace skylut
