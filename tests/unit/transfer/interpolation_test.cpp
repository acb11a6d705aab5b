#include "geometry/interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skylut::transfer {
namespace {

const std::vector<double> kNodes = {0.0, 1.0, 2.5, 3.0, 5.0, 5.5, 7.0};

double interpolate(double x, double (*f)(double)) {
  const InterpolationWeights weights = CubicInterpolation(kNodes)(x);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
    sum += weights.weight[i] * f(kNodes[static_cast<std::size_t>(weights.first + i)]);
  return sum;
}

// Four weights determine a cubic; the weights are single precision and of size 1, the values up to 300.
TEST(Interpolation, CubicsAreExact) {
  const auto cubic = [](double x) { return 1.0 - 2.0 * x + 0.5 * x * x + 0.7 * x * x * x; };
  for (double x = 0.0; x <= 7.0; x += 0.05) EXPECT_NEAR(interpolate(x, cubic), cubic(x), 300.0 * 2e-7) << x;
}

TEST(Interpolation, NodesKeepTheirValues) {
  const auto wild = [](double x) { return std::sin(17.0 * x); };
  for (const double node : kNodes) EXPECT_NEAR(interpolate(node, wild), wild(node), 1e-7) << node;
}

TEST(Interpolation, TapsSurroundThePoint) {
  for (double x = 0.05; x < 7.0; x += 0.1) {
    const InterpolationWeights weights = CubicInterpolation(kNodes)(x);
    ASSERT_GE(weights.first, 0);
    ASSERT_LE(weights.first + 3, 6);
    const auto first = static_cast<std::size_t>(weights.first);
    EXPECT_LE(kNodes[first], x);
    EXPECT_GE(kNodes[first + 3], x);
    // Away from the ends, two on either side.
    if (x > kNodes[1] && x < kNodes[5]) {
      EXPECT_LE(kNodes[first + 1], x);
      EXPECT_GE(kNodes[first + 2], x);
    }
  }
}

TEST(Interpolation, BeyondTheEndsTheNearestNodeCounts) {
  const auto any = [](double x) { return std::cos(x); };
  EXPECT_EQ(interpolate(-3.0, any), any(0.0));
  EXPECT_EQ(interpolate(100.0, any), any(7.0));
}

}  // namespace
}  // namespace skylut::transfer
