#include "spherical/lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace skylut::transfer {
namespace {

using Lanes = LaneRegister<4>::type;

TEST(Lanes, ExponentialIsAccurateToItsLastDigits) {
  double worst = 0.0;
  for (int i = 0; i <= 87 * 64; ++i) {
    const float x = static_cast<float>(i) / 64.0f;
    const double exact = std::exp(-static_cast<double>(x));
    worst = std::max(worst, std::abs(static_cast<double>(exp_minus(broadcast<Lanes>(x))[1]) / exact - 1.0));
  }
  // Rounding of eight multiply-adds of numbers below 1, each at most 2^-24 = 6e-8, most of them damped.
  EXPECT_LT(worst, 3e-7);
  EXPECT_EQ(exp_minus(broadcast<Lanes>(0.0f))[0], 1.0f);
}

TEST(Lanes, ExponentialEndsAtZero) {
  for (float x : {87.01f, 88.0f, 90.0f, 1e4f, 1e30f, INFINITY})
    EXPECT_EQ(exp_minus(broadcast<Lanes>(x))[3], 0.0f) << x;
}

TEST(Lanes, LanesAreIndependent) {
  const Lanes x = {0.0f, 0.7f, 12.5f, 100.0f};
  const Lanes all = exp_minus(x);
  for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(all[lane], exp_minus(broadcast<Lanes>(x[lane]))[0]);
}

TEST(Lanes, StepWeightsFollowTheClosedForm) {
  std::vector<float> depths = {0.499999f, 0.5f, 0.500001f};
  for (float t = 1e-6f; t < 80.0f; t *= 1.07f) depths.push_back(t);
  for (const float t : depths) {
    const long double exact_t = static_cast<long double>(t);
    const long double absorbed = -std::expm1(-exact_t);
    const long double mean = absorbed / exact_t;
    // The closed forms lose the digits of t: below 1e-3 three terms of their series, remainder t³/24 of them.
    const bool thin = t < 1e-3f;
    const long double local =
        thin ? exact_t / 2 - exact_t * exact_t / 6 + exact_t * exact_t * exact_t / 24 : 1 - mean;
    const long double upwind = thin ? exact_t / 2 - exact_t * exact_t / 3 + exact_t * exact_t * exact_t / 8
                                    : mean - std::exp(-exact_t);
    const StepWeights<Lanes> weights = step_weights(broadcast<Lanes>(t));
    // Worst just above t = 0.5, where 1 - (1-e^-t)/t = 0.213 has lost two of 24 bits of terms that carry
    // the exponential's 3e-7.
    constexpr double kRelative = 2e-6;
    EXPECT_NEAR(static_cast<double>(weights.local[0] / local), 1.0, kRelative) << t;
    EXPECT_NEAR(static_cast<double>(weights.upwind[0] / upwind), 1.0, kRelative) << t;
    EXPECT_NEAR(static_cast<double>(weights.transmission[0] / std::exp(-exact_t)), 1.0, 3e-7) << t;
  }
}

// In a uniform source equal to the radiance nothing changes along the ray: the weights add up to 1.
TEST(Lanes, StepWeightsConserveAUniformField) {
  for (float t = 0.0f; t < 100.0f; t = 1.1f * t + 1e-5f) {
    const StepWeights<Lanes> weights = step_weights(broadcast<Lanes>(t));
    // Three roundings of numbers below 1, and the exponential's error.
    EXPECT_NEAR(weights.transmission[2] + weights.upwind[2] + weights.local[2], 1.0f, 5e-7f) << t;
    EXPECT_GE(weights.upwind[2], 0.0f);
    EXPECT_GE(weights.local[2], weights.upwind[2] - 1e-7f);
  }
}

/// Matrix of that size in panels, with entries that differ, and lanes to multiply it by.
struct Product {
  Product(int rows_, int columns_) : rows(rows_), columns(columns_) {
    const int panel_rows = (rows + kPanel - 1) / kPanel * kPanel;
    panels.resize(static_cast<std::size_t>(panel_rows * columns));
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        panels[static_cast<std::size_t>((row / kPanel * columns + column) * kPanel + row % kPanel)] =
            entry(row, column);
  }
  static float entry(int row, int column) {
    return static_cast<float>(row + 1) - 0.5f * static_cast<float>(column);
  }
  static Lanes input(int column) {
    const float c = static_cast<float>(column);
    return Lanes{1.0f, c, -c, 0.25f * c};
  }
  Lanes expected(int row) const {
    Lanes sum{};
    for (int column = 0; column < columns; ++column) sum += entry(row, column) * input(column);
    return sum;
  }
  int rows;
  int columns;
  std::vector<float> panels;
};

// Small integers and quarters: every product and sum is exact, whatever their order.
TEST(Lanes, MatrixTimesLanes) {
  for (int rows : {1, 4, 5, 6, 10, 13})
    for (int columns : {1, 3, 8}) {
      const Product product(rows, columns);
      constexpr int kStrideIn = 3;
      constexpr int kStrideOut = 2;
      Lanes in[8 * kStrideIn] = {};
      Lanes out[13 * kStrideOut];
      for (Lanes& value : out) value = broadcast<Lanes>(7.0f);
      for (int column = 0; column < columns; ++column) in[column * kStrideIn] = Product::input(column);
      apply_matrix(product.panels.data(), rows, columns, in, kStrideIn, out, kStrideOut);
      apply_matrix<Lanes, true>(product.panels.data(), rows, columns, in, kStrideIn, out, kStrideOut);
      for (int row = 0; row < 13; ++row)
        for (int lane = 0; lane < 4; ++lane) {
          const float wanted = row < rows ? 2.0f * product.expected(row)[lane] : 7.0f;
          EXPECT_EQ(out[row * kStrideOut][lane], wanted) << rows << " x " << columns << ", row " << row;
          EXPECT_EQ(out[row * kStrideOut + 1][lane], 7.0f);  // between the strides
        }
    }
}

}  // namespace
}  // namespace skylut::transfer
