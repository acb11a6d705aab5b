#include "skylut/core/generalised_legendre.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "skylut/core/check.hpp"

namespace skylut {

std::vector<double> generalised_legendre(int m, int n, int max_l, double mu) {
  SKYLUT_CHECK_GE(m, 0);
  const int least = std::max(m, std::abs(n));
  std::vector<double> d;
  if (max_l < least) return d;
  // d^least = √((2 least)! / (|m-n|! |m+n|!)) ((1-μ)/2)^(|m-n|/2) ((1+μ)/2)^(|m+n|/2).
  const int apart = std::abs(m - n);
  const int together = std::abs(m + n);
  const double ln_factor =
      0.5 * (std::lgamma(2.0 * least + 1.0) - std::lgamma(apart + 1.0) - std::lgamma(together + 1.0));
  double previous = 0.0;
  double current = std::exp(ln_factor) * std::pow(std::max(0.0, 0.5 * (1.0 - mu)), 0.5 * apart) *
                   std::pow(std::max(0.0, 0.5 * (1.0 + mu)), 0.5 * together);
  d.push_back(current);
  const auto root = [m, n](int l) {
    return std::sqrt(static_cast<double>(l * l - m * m)) * std::sqrt(static_cast<double>(l * l - n * n));
  };
  for (int l = least; l < max_l; ++l) {
    // For l = 0 (m = n = 0) the recurrence divides by 0; its limit is P_1 = μ.
    const double next =
        l == 0 ? mu
               : ((2.0 * l + 1.0) * (l * (l + 1.0) * mu - m * n) * current - (l + 1.0) * root(l) * previous) /
                     (l * root(l + 1));
    previous = current;
    current = next;
    d.push_back(current);
  }
  return d;
}

}  // namespace skylut
