#include "geometry/slant_depth_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <random>

namespace skylut::transfer {
namespace {

struct Case {
  double planet_km;
  double step_km;          ///< thickness of the layers, the last twice as thick
  double scale_height_km;  ///< of the extinction
  double depth;            ///< vertical
};

class SunDepthOf : public testing::TestWithParam<Case> {
 protected:
  SunDepthOf() {
    std::vector<double> levels{0.0};
    while (levels.back() < 100.0 - 1e-9)
      levels.push_back(std::min(100.0, levels.back() + GetParam().step_km * (1.0 + levels.back() / 20.0)));
    layers = std::make_unique<ShellGeometry>(levels, GetParam().planet_km);
    const double scale = GetParam().scale_height_km;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
      extinction.push_back(GetParam().depth *
                           (std::exp(-levels[i] / scale) - std::exp(-levels[i + 1] / scale)) /
                           (levels[i + 1] - levels[i]));
    grid = std::make_unique<SlantDepthGrid>(*layers);
  }
  double table(const float* path, int point) const {
    double sum = 0.0;
    for (std::size_t layer = 0; layer < extinction.size(); ++layer)
      sum += extinction[layer] * path[static_cast<std::size_t>(point) * extinction.size() + layer];
    return sum;
  }
  double interpolated(const SlantDepthWeights& weights) const {
    const SlantDepthView view = grid->view();
    double depth = extinction[static_cast<std::size_t>(weights.layer)] * weights.to_level_km;
    for (int t = 0; t < 4; ++t)
      depth += weights.from_level_weight[t] * table(view.from_level_path_km, weights.from_level + t);
    if (weights.from_perigee < 0) return depth;
    double whole = 0.0;
    for (int t = 0; t < 4; ++t)
      whole += weights.from_perigee_weight[t] * table(view.from_perigee_path_km, weights.from_perigee + t);
    return whole - depth;
  }
  std::unique_ptr<ShellGeometry> layers;
  std::vector<double> extinction;
  std::unique_ptr<SlantDepthGrid> grid;
};

// Against the sum over the exact paths, at random points and sun angles from the zenith to the shadow's edge.
// What matters is the transmission: an error of the depth counts as far as light is left (e^-7).
TEST_P(SunDepthOf, MatchesTheExactPaths) {
  std::mt19937 random(20261122);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> length;
  int from_below = 0;
  for (int i = 0; i < 4000; ++i) {
    const double altitude = i % 3 == 0 ? layers->level_km(i / 3 % layers->levels()) : 30.0 * uniform(random);
    const double dip = std::acos(GetParam().planet_km / (GetParam().planet_km + altitude));
    const double lowest = -std::sin(dip);
    const double u = uniform(random);
    const double cosine = i % 2 == 0 ? lowest + (0.1 - lowest) * u : lowest + (1.0 - lowest) * u;
    if (!layers->path_to_top(altitude, cosine, length)) continue;
    if (cosine < 0.0) ++from_below;
    const double exact = std::inner_product(length.begin(), length.end(), extinction.begin(), 0.0);
    const SlantDepthWeights weights = grid->weights_towards(altitude, cosine);
    ASSERT_NE(weights.from_level, kShadow);
    const double light_left = std::min(1.0, std::exp(3.0 - exact));
    EXPECT_NEAR(interpolated(weights) * light_left, exact * light_left, 3e-4) << altitude << " " << cosine;
  }
  if (GetParam().planet_km < 1e5) {
    EXPECT_GT(from_below, 100);
  }
}

TEST_P(SunDepthOf, TheShadowIsDark) {
  EXPECT_EQ(grid->weights_towards(0.0, -1e-6).from_level, kShadow);
  EXPECT_EQ(grid->weights_towards(10.0, -0.9).from_level, kShadow);
  EXPECT_NE(grid->weights_towards(0.0, 0.0).from_level, kShadow);
}

INSTANTIATE_TEST_SUITE_P(Media, SunDepthOf,
                         testing::Values(Case{6371.0, 0.25, 8.0, 0.35}, Case{6371.0, 0.25, 2.0, 1.0},
                                         Case{6371.0, 1.0, 1.2, 2.0}, Case{3390.0, 1.0, 8.0, 0.5},
                                         Case{6.4e7, 1.0, 8.0, 0.5}));

}  // namespace
}  // namespace skylut::transfer
