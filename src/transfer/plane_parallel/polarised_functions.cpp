#include "polarised_functions.hpp"

#include "skylut/core/generalised_legendre.hpp"

namespace skylut::plane_parallel {

PolarisedFunctions polarised_functions(int order, int degrees, const Eigen::VectorXd& mu) {
  PolarisedFunctions functions{Eigen::MatrixXd::Zero(degrees - order, mu.size()),
                               Eigen::MatrixXd::Zero(degrees - order, mu.size())};
  const double sign = order == 1 ? -1.0 : 1.0;
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    const std::vector<double> same = generalised_legendre(order, 2, degrees - 1, mu[i]);
    const std::vector<double> opposite = generalised_legendre(order, -2, degrees - 1, mu[i]);
    const Eigen::Index first = functions.r.rows() - static_cast<Eigen::Index>(same.size());
    for (std::size_t k = 0; k < same.size(); ++k) {
      const Eigen::Index row = first + static_cast<Eigen::Index>(k);
      functions.r(row, i) = 0.5 * (sign * same[k] + opposite[k]);
      functions.t(row, i) = 0.5 * (sign * same[k] - opposite[k]);
    }
  }
  return functions;
}

}  // namespace skylut::plane_parallel
