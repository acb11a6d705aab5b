#include "skylut/core/legendre.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/check.hpp"

namespace skylut {

std::vector<double> normalised_legendre(int m, int max_l, double mu) {
  SKYLUT_CHECK_GE(m, 0);
  SKYLUT_CHECK_LE(m, max_l);
  std::vector<double> lambda(static_cast<std::size_t>(max_l - m + 1));
  // Λ_mm = √((2m-1)!!/(2m)!!) (1-μ²)^{m/2}.
  const double sine = std::sqrt(std::max(0.0, (1.0 - mu) * (1.0 + mu)));
  double previous = 0.0;
  double current = 1.0;
  for (int k = 1; k <= m; ++k) current *= sine * std::sqrt((2.0 * k - 1.0) / (2.0 * k));
  lambda[0] = current;
  for (int l = m + 1; l <= max_l; ++l) {
    const double below = std::sqrt(static_cast<double>((l - 1) * (l - 1) - m * m));
    const double here = std::sqrt(static_cast<double>(l * l - m * m));
    const double next = ((2.0 * l - 1.0) * mu * current - below * previous) / here;
    previous = current;
    current = next;
    lambda[static_cast<std::size_t>(l - m)] = current;
  }
  return lambda;
}

}  // namespace skylut
