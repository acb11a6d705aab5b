#include "skylut/models/perez.hpp"

#include <gtest/gtest.h>

#include "skylut/core/constants.hpp"

namespace skylut {
namespace {

TEST(Perez, ValueByHand) {
  // A = 1, B = -1, C = 2, D = -3, E = 0.5 at θ = 60°, γ = 90°: (1 + e^{-2}) (1 + 2 e^{-3π/2}).
  const PerezCoefficients k{1.0, -1.0, 2.0, -3.0, 0.5};
  const double expected = (1.0 + std::exp(-2.0)) * (1.0 + 2.0 * std::exp(-1.5 * kPi));
  EXPECT_NEAR(perez(k, kPi / 3.0, kPi / 2.0), expected, 1e-14);
}

TEST(Perez, ZenithIsOne) {
  const PerezCoefficients k{-0.9, -0.3, 5.0, -2.5, 0.3};
  EXPECT_DOUBLE_EQ(perez_relative(k, 0.0, 1.1, 1.1), 1.0);
}

// e^{B/cosθ} tends to 0 at the horizon, and is 0 there and below although cos 90° rounds to 6e-17.
TEST(Perez, HorizonIsTheLimit) {
  const PerezCoefficients k{3.0, -1e-5, 0.0, 0.0, 0.0};
  EXPECT_EQ(perez(k, 0.5 * kPi, 1.0), 1.0);
  EXPECT_EQ(perez(k, 0.5 * kPi + 0.1, 1.0), 1.0);
  EXPECT_GT(perez(k, 0.5 * kPi - 1e-3, 1.0), 1.0);
}

}  // namespace
}  // namespace skylut
