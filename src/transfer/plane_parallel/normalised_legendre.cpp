#include "normalised_legendre.hpp"

#include "skylut/core/legendre.hpp"

namespace skylut::plane_parallel {

Eigen::MatrixXd normalised_legendre(int order, int degrees, const Eigen::VectorXd& mu) {
  Eigen::MatrixXd values(degrees - order, mu.size());
  for (Eigen::Index i = 0; i < mu.size(); ++i) {
    const std::vector<double> column = skylut::normalised_legendre(order, degrees - 1, mu[i]);
    values.col(i) = Eigen::Map<const Eigen::VectorXd>(column.data(), values.rows());
  }
  return values;
}

}  // namespace skylut::plane_parallel
