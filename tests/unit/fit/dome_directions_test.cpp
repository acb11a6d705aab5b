#include "skylut/fit/dome_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

// What each direction stands for adds up to the dome, of whatever sun and horizon: 2π (1 - cos θ_h).
TEST(DomeDirections, CoverTheDome) {
  for (const double sun : {0.0, 3.0, 45.0, 88.7, 90.0, 96.0})
    for (const double horizon : {90.0, 95.6})
      for (const auto set : {&dome_directions, &dome_check_directions}) {
        const DomeDirections dome = set({sun, 90.0}, horizon);
        ASSERT_EQ(dome.directions.size(), dome.solid_angles_sr.size());
        EXPECT_EQ(dome.directions.front().zenith_deg, 0.0);
        EXPECT_NEAR(std::accumulate(dome.solid_angles_sr.begin(), dome.solid_angles_sr.end(), 0.0),
                    2.0 * kPi * (1.0 - std::cos(horizon * kRadiansPerDegree)), 1e-9)
            << sun << " " << horizon;
        for (std::size_t i = 0; i < dome.directions.size(); ++i) {
          EXPECT_LE(dome.directions[i].zenith_deg, horizon);
          EXPECT_GT(dome.solid_angles_sr[i], 0.0);
        }
      }
}

// Means over the dome, as the weights have them: cos²θ is 1/3; cos²γ too, by symmetry about the horizon.
TEST(DomeDirections, WeightsIntegrate) {
  for (const auto& [set, tolerance] :
       {std::pair{&dome_directions, 0.02}, std::pair{&dome_check_directions, 0.003}}) {
    const Direction sun{60.0, 200.0};
    const DomeDirections dome = set(sun, 90.0);
    double of_zenith = 0.0;
    double of_gamma = 0.0;
    for (std::size_t i = 0; i < dome.directions.size(); ++i) {
      const double weight = dome.solid_angles_sr[i] / (2.0 * kPi);
      of_zenith += weight * std::pow(std::cos(dome.directions[i].zenith_deg * kRadiansPerDegree), 2);
      of_gamma += weight * std::pow(std::cos(angle_between(dome.directions[i], sun)), 2);
    }
    EXPECT_NEAR(of_zenith, 1.0 / 3.0, tolerance / 3.0);
    EXPECT_NEAR(of_gamma, 1.0 / 3.0, tolerance / 3.0);
  }
}

// Nothing of the dome goes unseen: how far any view can be from the next direction of the set.
TEST(DomeDirections, LeaveNothingUnseen) {
  for (const double sun_deg : {45.0, 90.0}) {
    const Direction sun{sun_deg, 0.0};
    const DomeDirections dome = dome_directions(sun);
    const auto nearest = [&](const Direction& view) {
      double least = kPi;
      for (const Direction& one : dome.directions) least = std::min(least, angle_between(one, view));
      return least * kDegreesPerRadian;
    };
    for (double azimuth = 0.0; azimuth <= 180.0; azimuth += 3.0) {
      EXPECT_LE(nearest({30.0, azimuth}), 11.0);
      EXPECT_LE(nearest({89.95, azimuth}), 7.6);
    }
    for (const double offset : {0.0, 0.5, 1.0})
      EXPECT_LT(nearest({sun_deg - offset, 0.0}), 1e-9) << "above the sun";
    EXPECT_LT(nearest({sun_deg, 1.0 / std::sin(sun_deg * kRadiansPerDegree)}), 0.01) << "beside it";
  }
  std::set<double> rings;
  for (const Direction& one : dome_directions({45.0, 0.0}).directions) rings.insert(one.zenith_deg);
  for (const double ring : {80.0, 82.0, 84.0, 86.0, 87.0, 88.0, 89.0, 89.5, 89.9, 90.0})
    EXPECT_TRUE(rings.contains(ring)) << ring;
}

// No direction is seen by both sets, but the zenith, to which everything is scaled.
TEST(DomeDirections, TheCheckIsIndependent) {
  for (const double sun_deg : {0.0, 20.0, 45.0, 90.0}) {
    const DomeDirections fit = dome_directions({sun_deg, 0.0});
    const DomeDirections check = dome_check_directions({sun_deg, 0.0});
    EXPECT_GT(check.directions.size(), 1.4 * static_cast<double>(fit.directions.size()));
    for (std::size_t i = 1; i < check.directions.size(); ++i)
      for (const Direction& one : fit.directions)
        ASSERT_GT(angle_between(check.directions[i], one), 0.02 * kRadiansPerDegree)
            << check.directions[i].zenith_deg << " " << check.directions[i].azimuth_deg;
  }
}

TEST(DomeDirections, AStretchedDomeHasItsRingsInPlace) {
  const DomeDirections plain = dome_directions({0.0, 0.0});
  const DomeDirections stretched = dome_directions({0.0, 0.0}, 95.0);
  EXPECT_EQ(plain.directions.back().zenith_deg, 90.0);
  EXPECT_NEAR(stretched.directions.back().zenith_deg, 95.0, 1e-12);
}

TEST(DomeDirections, EmphasisOfTheHorizon) {
  EXPECT_EQ(horizon_emphasis(0.0), 1.0);
  EXPECT_NEAR(horizon_emphasis(75.0 * kRadiansPerDegree), 2.0, 1e-3);
  EXPECT_NEAR(horizon_emphasis(0.5 * kPi), 3.0, 1e-12);
  EXPECT_NEAR(horizon_emphasis(0.55 * kPi), 3.0, 1e-12);
}

}  // namespace
}  // namespace skylut
