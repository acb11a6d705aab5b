#include "skylut/core/legendre.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

// ∫₋₁¹ Λ_lm Λ_km dμ = 2/(2l+1) δ_lk; the products have degree <= 60, which 40 nodes integrate exactly.
TEST(Legendre, AreOrthogonal) {
  const Quadrature rule = gauss_legendre(40, -1.0, 1.0);
  for (const int m : {0, 1, 7, 20}) {
    const int max_l = 30;
    std::vector<std::vector<double>> values;
    for (const double mu : rule.node) values.push_back(normalised_legendre(m, max_l, mu));
    for (std::size_t a = 0; a < values[0].size(); a += 3)
      for (std::size_t b = 0; b < values[0].size(); b += 2) {
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.node.size(); ++i)
          sum += rule.weight[i] * values[i][a] * values[i][b];
        const double expected = a == b ? 2.0 / (2.0 * (m + static_cast<double>(a)) + 1.0) : 0.0;
        EXPECT_NEAR(sum, expected, 1e-13) << "m " << m << ", l " << a + static_cast<std::size_t>(m);
      }
  }
}

// Addition theorem at μ = 0.3, μ' = -0.6, φ = 1: P_l(cosΘ) by Bonnet's recurrence.
TEST(Legendre, AdditionTheorem) {
  const double mu = 0.3;
  const double other = -0.6;
  const double cosine = mu * other + std::sqrt((1 - mu * mu) * (1 - other * other)) * std::cos(1.0);
  double previous = 1.0;
  double legendre = cosine;
  for (int l = 1; l <= 20; ++l) {
    double sum = 0.0;
    for (int m = 0; m <= l; ++m)
      sum += (m == 0 ? 1.0 : 2.0) * normalised_legendre(m, l, mu).back() *
             normalised_legendre(m, l, other).back() * std::cos(m);
    EXPECT_NEAR(sum, legendre, 1e-13) << l;
    const double next = ((2.0 * l + 1.0) * cosine * legendre - l * previous) / (l + 1.0);
    previous = legendre;
    legendre = next;
  }
}

}  // namespace
}  // namespace skylut
