#include "skylut/core/interpolation.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace skylut {
namespace {

const std::vector<double> kNodes{1.0, 2.0, 4.0, 8.0};

TEST(Interpolation, PieceOf) {
  EXPECT_EQ(piece_of(kNodes, 1.0), 0u);
  EXPECT_EQ(piece_of(kNodes, 1.999), 0u);
  EXPECT_EQ(piece_of(kNodes, 2.0), 1u) << "a node belongs to the piece above it";
  EXPECT_EQ(piece_of(kNodes, 7.0), 2u);
  EXPECT_EQ(piece_of(kNodes, 8.0), 2u) << "the last node to the last piece";
  EXPECT_EQ(piece_of(kNodes, -5.0), 0u);
  EXPECT_EQ(piece_of(kNodes, 50.0), 2u);
  struct Row {
    double x;
    int other;
  };
  EXPECT_EQ(piece_of(std::vector<Row>{{0.0, 1}, {1.0, 1}, {2.0, 1}}, 1.5, &Row::x), 1u);
}

TEST(Interpolation, HeldBracket) {
  const Bracket inside = held_bracket(kNodes, 5.0);
  EXPECT_EQ(inside.below, 2u);
  EXPECT_EQ(inside.above, 3u);
  EXPECT_EQ(inside.part, 0.25);
  for (const double x : {0.5, 1.0}) EXPECT_EQ(held_bracket(kNodes, x).above, 0u) << x;
  for (const double x : {8.0, 9.0}) EXPECT_EQ(held_bracket(kNodes, x).below, 3u) << x;
  EXPECT_EQ(held_bracket(std::vector<double>{3.0}, 7.0).above, 0u);
}

TEST(Interpolation, BetweenTwoValues) {
  EXPECT_EQ(linear(1.0, 3.0, 0.25), 1.5);
  EXPECT_NEAR(log_linear(1.0, 16.0, 0.25), 2.0, 1e-15);
  EXPECT_NEAR(log_linear_or_linear(16.0, 1.0, 0.75), 2.0, 1e-15);
  EXPECT_EQ(log_linear_or_linear(0.0, 4.0, 0.25), 1.0);
}

// A cubic comes back exactly; at a node only that node counts.
TEST(Interpolation, CubicWeights) {
  const auto cubic = [](double t) { return 2.0 - t + 0.5 * t * t - 3.0 * t * t * t; };
  for (const double t : {0.0, 0.3, 0.9, 1.0}) {
    const std::array<double, 4> weight = cubic_weights(t);
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += weight[i] * cubic(static_cast<double>(i) - 1.0);
    EXPECT_NEAR(sum, cubic(t), 1e-14) << t;
  }
  EXPECT_EQ(cubic_weights(0.0)[1], 1.0);
  EXPECT_EQ(cubic_weights(1.0)[1], 0.0);
}

}  // namespace
}  // namespace skylut
