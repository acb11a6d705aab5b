#pragma once

#include <Eigen/Core>

namespace skylut::plane_parallel {

/// core/legendre.hpp at many cosines.
/// @param order    m >= 0
/// @param degrees  functions l = m … degrees-1 are returned
/// @param mu       cosines, [0, 1]
/// @return  (degrees - m) × mu.size()
Eigen::MatrixXd normalised_legendre(int order, int degrees, const Eigen::VectorXd& mu);

}  // namespace skylut::plane_parallel
