#include "skylut/forms/dome_views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

double whole(const DomeViews& dome) {
  return std::accumulate(dome.solid_angle.begin(), dome.solid_angle.end(), 0.0);
}

// The mean of cosθ over the dome is 1/2: irradiance of an even sky is π.
double flux(const DomeViews& dome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < dome.views.size(); ++i)
    sum += dome.solid_angle[i] * std::cos(dome.views[i].zenith_deg * kRadiansPerDegree);
  return sum;
}

TEST(DomeViews, ShareTheDome) {
  for (const double sun_deg : {0.0, 20.0, 45.0, 70.0, 90.0, 96.0})
    for (const auto views : {fitting_views, checking_views}) {
      const DomeViews dome = views({sun_deg, 30.0});
      EXPECT_NEAR(whole(dome), 2.0 * kPi, 0.03) << sun_deg;
      EXPECT_NEAR(flux(dome), kPi, 0.03) << sun_deg;
    }
}

TEST(DomeViews, BeginAtTheZenithAndReachTheHorizonAndTheSun) {
  const Direction sun{50.0, 200.0};
  for (const auto views : {fitting_views, checking_views}) {
    const DomeViews dome = views(sun);
    EXPECT_EQ(dome.views.front(), (Direction{0.0, 0.0}));
    double lowest = 0.0;
    double nearest = 180.0;
    for (const Direction& view : dome.views) {
      ASSERT_LE(view.zenith_deg, 90.0);
      lowest = std::max(lowest, view.zenith_deg);
      nearest = std::min(nearest, angle_between(view, sun) * kDegreesPerRadian);
    }
    EXPECT_GT(lowest, 89.8);
    EXPECT_NEAR(nearest, views(sun).views.size() > 400 ? 0.5 : 0.75, 1e-9);
  }
}

TEST(DomeViews, CheckWhereNothingWasFitted) {
  const Direction sun{33.0, 0.0};
  const DomeViews fitted = fitting_views(sun);
  const DomeViews checked = checking_views(sun);
  EXPECT_GT(checked.views.size(), 2 * fitted.views.size() - 50);
  std::size_t same = 0;
  for (const Direction& view : checked.views)
    same += static_cast<std::size_t>(
        std::count_if(fitted.views.begin(), fitted.views.end(),
                      [&](const Direction& f) { return angle_between(view, f) < 1e-3 * kRadiansPerDegree; }));
  EXPECT_EQ(same, 1u);  // the zenith
}

}  // namespace
}  // namespace skylut
