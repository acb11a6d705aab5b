#pragma once

#include <Eigen/Core>

namespace skylut::plane_parallel {

/// The functions that carry Q and U as Λ_lm carries I (Siewert 1981; Hovenier & van der Mee 1983):
///   R = ½ (s d^l_m2 + d^l_m,-2),  T = ½ (s d^l_m2 - d^l_m,-2),  s = (-1)^m for m <= 2, else 1
/// with the d of core/generalised_legendre.hpp; rows l = m …, 0 for l < 2; one column per cosine.
struct PolarisedFunctions {
  Eigen::MatrixXd r;
  Eigen::MatrixXd t;
};

/// @param order    m >= 0
/// @param degrees  functions l = m … degrees-1 are returned
/// @param mu       cosines, [0, 1]
PolarisedFunctions polarised_functions(int order, int degrees, const Eigen::VectorXd& mu);

}  // namespace skylut::plane_parallel
