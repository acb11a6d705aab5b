#include "skylut/core/generalised_legendre.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/legendre.hpp"
#include "skylut/core/quadrature.hpp"

namespace {

using skylut::generalised_legendre;

TEST(GeneralisedLegendre, ClosedFormsOfDegreeTwo) {
  for (const double mu : {-1.0, -0.7, 0.0, 0.3, 1.0}) {
    EXPECT_NEAR(generalised_legendre(0, 2, 2, mu)[0], std::sqrt(6.0) / 4.0 * (1.0 - mu * mu), 1e-15);
    EXPECT_NEAR(generalised_legendre(2, 2, 2, mu)[0], 0.25 * (1.0 + mu) * (1.0 + mu), 1e-15);
    EXPECT_NEAR(generalised_legendre(2, -2, 2, mu)[0], 0.25 * (1.0 - mu) * (1.0 - mu), 1e-15);
  }
}

TEST(GeneralisedLegendre, WithoutSpinTheyAreAssociatedLegendre) {
  for (const int m : {0, 1, 3}) {
    const std::vector<double> lambda = skylut::normalised_legendre(m, 12, 0.37);
    const std::vector<double> d = generalised_legendre(m, 0, 12, 0.37);
    ASSERT_EQ(lambda.size(), d.size());
    for (std::size_t i = 0; i < d.size(); ++i) EXPECT_NEAR(d[i], lambda[i], 1e-13);
  }
}

// ½∫ d^l d^k dμ = δ_lk / (2l+1).
TEST(GeneralisedLegendre, AreOrthogonal) {
  const skylut::Quadrature rule = skylut::gauss_legendre(40, -1.0, 1.0);
  for (const int m : {0, 1, 2, 5})
    for (const int n : {2, -2}) {
      const int least = std::max(m, 2);
      for (int l = least; l <= 9; ++l)
        for (int k = least; k <= 9; ++k) {
          double sum = 0.0;
          for (std::size_t i = 0; i < rule.node.size(); ++i) {
            const std::vector<double> d = generalised_legendre(m, n, 9, rule.node[i]);
            sum += 0.5 * rule.weight[i] * d[static_cast<std::size_t>(l - least)] *
                   d[static_cast<std::size_t>(k - least)];
          }
          EXPECT_NEAR(sum, l == k ? 1.0 / (2.0 * l + 1.0) : 0.0, 1e-13) << m << " " << n << " " << l << k;
        }
    }
}

TEST(GeneralisedLegendre, NothingBelowTheLeastDegree) {
  EXPECT_TRUE(generalised_legendre(0, 2, 1, 0.5).empty());
}

}  // namespace
