#include "skylut/core/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

// The rules of large Mie spheres: Σ w P_l(x) = 0 for every l but 0. Each weight carries the rounding of a
// recurrence of as many steps as there are nodes.
TEST(Quadrature, ManyNodes) {
  for (const int count : {201, 402, 3000}) {
    const Quadrature rule = gauss_legendre(count, -1.0, 1.0);
    std::vector<double> moment(50);
    double before = -2.0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      EXPECT_GT(rule.node[i], before);
      before = rule.node[i];
      for (unsigned l = 0; l < moment.size(); ++l)
        moment[l] += rule.weight[i] * std::legendre(l, rule.node[i]);
    }
    for (std::size_t l = 0; l < moment.size(); ++l)
      EXPECT_NEAR(moment[l], l == 0 ? 2.0 : 0.0, 1e-12) << count << " nodes, degree " << l;
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
