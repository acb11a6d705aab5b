#include "skylut/core/cosine_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/low_discrepancy.hpp"

namespace skylut {
namespace {

TEST(CosineSeries, FindsTheCoefficientsOfAFiniteSeries) {
  constexpr std::size_t kCount = 7;
  const std::vector<double> c{3.0, -1.0, 0.5, 0.0, 2.0, -0.25, 0.125};
  const std::vector<double> weights = cosine_series(kCount);
  for (std::size_t m = 0; m < kCount; ++m) {
    double found = 0.0;
    for (std::size_t k = 0; k < kCount; ++k) {
      double value = 0.0;
      for (std::size_t n = 0; n < kCount; ++n)
        value += c[n] * std::cos(kPi * static_cast<double>(n * k) / 6.0);
      found += weights[m * kCount + k] * value;
    }
    EXPECT_NEAR(found, c[m], 1e-14) << m;
  }
  EXPECT_EQ(cosine_series(1), std::vector<double>{1.0});
}

TEST(LowDiscrepancy, MirrorsDigits) {
  EXPECT_EQ(low_discrepancy(0, 2), 0.0);
  EXPECT_EQ(low_discrepancy(1, 2), 0.5);
  EXPECT_EQ(low_discrepancy(6, 2), 0.375);  // 110 becomes 0.011
  EXPECT_NEAR(low_discrepancy(5, 3), 2.0 / 3.0 + 1.0 / 9.0, 1e-15);
}

}  // namespace
}  // namespace skylut
