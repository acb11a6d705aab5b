#pragma once

#include <ceres/cost_function.h>

#include <vector>

#include "multistart.hpp"

namespace skylut::fit_detail {

/// Goes on from where Levenberg-Marquardt has crept to its limit of iterations: along the floor of a curved
/// valley J^T J is nearly singular, and only the second derivatives of the residuals know how the floor
/// bends. Newton's method with the whole Hessian (central differences of the gradient), damped, on the
/// parameters that no bound holds. [fit.md F5]
///
/// Converged means: the bounds hold what the gradient pushes against them, the Hessian of the others has no
/// negative eigenvalue, and by Newton's own estimate the cost cannot fall by more than 1e-14 of itself, or no
/// step lowers it in double precision.
/// @return `from` improved, its iterations added to
Minimum newton_search(const ceres::CostFunction& residuals, const std::vector<ParameterBounds>& bounds,
                      Minimum from, int max_iterations);

}  // namespace skylut::fit_detail
