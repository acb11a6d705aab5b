#include "skylut/compare/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(Metrics, ByHand) {
  const std::vector<Yxy> sky{{1.1, 0.30, 0.31}, {0.7, 0.32, 0.33}};
  const std::vector<Yxy> reference{{1.0, 0.30, 0.34}, {1.0, 0.30, 0.29}};
  const SkyDifference found = difference(sky, reference);
  EXPECT_NEAR(found.rmse_Y_rel, std::sqrt((0.01 + 0.09) / 2.0), 1e-15);
  EXPECT_NEAR(found.mean_Y_rel, -0.1, 1e-15);
  EXPECT_NEAR(found.rmse_x, std::sqrt(0.0004 / 2.0), 1e-15);
  EXPECT_NEAR(found.rmse_y, std::sqrt((0.0009 + 0.0016) / 2.0), 1e-15);
}

TEST(Metrics, RefusesWhatCannotBeCompared) {
  const std::vector<Yxy> one{{1.0, 0.3, 0.3}};
  const std::vector<Yxy> dark{{0.0, 0.3, 0.3}};
  EXPECT_THROW(difference(one, {}), InputError);
  EXPECT_THROW(difference(one, dark), InputError);
}

}  // namespace
}  // namespace skylut
