#include "skylut/core/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skylut {
namespace {

// n nodes integrate x^(2n-1) and below exactly: ∫₀¹ x^k dx = 1/(k+1).
TEST(Quadrature, GaussLegendreIsExactForPolynomials) {
  for (int count : {1, 2, 5, 10, 32}) {
    const Quadrature rule = gauss_legendre(count, 0.0, 1.0);
    for (int power = 0; power < 2 * count; ++power) {
      double sum = 0.0;
      for (std::size_t i = 0; i < rule.node.size(); ++i)
        sum += rule.weight[i] * std::pow(rule.node[i], power);
      EXPECT_NEAR(sum * (power + 1.0), 1.0, 1e-13) << count << " nodes, power " << power;
    }
  }
}

// Abramowitz & Stegun table 25.4: the outer node for n = 10 is 0.973906528517172.
TEST(Quadrature, PublishedNodes) {
  const Quadrature rule = gauss_legendre(10, -1.0, 1.0);
  EXPECT_NEAR(rule.node.back(), 0.973906528517172, 1e-15);
  EXPECT_NEAR(rule.weight.back(), 0.066671344308688, 1e-15);
}

}  // namespace
}  // namespace skylut
