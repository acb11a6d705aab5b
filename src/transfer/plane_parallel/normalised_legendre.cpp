#include "normalised_legendre.hpp"

#include <cmath>

namespace skylut::plane_parallel {

Eigen::MatrixXd normalised_legendre(int order, int degrees, const Eigen::VectorXd& mu) {
  const double m = order;
  Eigen::MatrixXd values(degrees - order, mu.size());
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    // Λ_mm = √((2m-1)!!/(2m)!!) (1-μ²)^{m/2}, then the recurrence in l (Dave & Armstrong 1970).
    const double sine = std::sqrt((1.0 - mu[i]) * (1.0 + mu[i]));
    double current = 1.0;
    for (int k = 1; k <= order; ++k) current *= std::sqrt((2.0 * k - 1.0) / (2.0 * k)) * sine;
    double previous = 0.0;
    for (int degree = order; degree < degrees; ++degree) {
      values(degree - order, i) = current;
      const double l = degree;
      const double next = ((2.0 * l + 1.0) * mu[i] * current - std::sqrt(l * l - m * m) * previous) /
                          std::sqrt((l + 1.0) * (l + 1.0) - m * m);
      previous = current;
      current = next;
    }
  }
  return values;
}

}  // namespace skylut::plane_parallel
