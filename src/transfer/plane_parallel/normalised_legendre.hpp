#pragma once

#include <Eigen/Core>

namespace skylut::plane_parallel {

/// Normalised associated Legendre functions Λ_lm(μ) = √((l-m)!/(l+m)!) P_lm(μ) without the sign (-1)^m,
/// so that P_l(cosΘ) = Σ_m (2-δ_m0) Λ_lm(μ) Λ_lm(μ') cos m(φ-φ') (addition theorem).
/// @param order    m >= 0
/// @param degrees  functions l = m … degrees-1 are returned
/// @param mu       cosines, [0, 1]
/// @return  (degrees - m) × mu.size()
Eigen::MatrixXd normalised_legendre(int order, int degrees, const Eigen::VectorXd& mu);

}  // namespace skylut::plane_parallel
