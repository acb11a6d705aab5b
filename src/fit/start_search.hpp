#pragma once

#include <vector>

#include "fit_problem.hpp"
#include "multistart.hpp"

namespace skylut::fit_detail {

/// Looks over a grid of B and D. At each node the linear form leaves a, c, e, in which the model is bilinear:
/// c and e follow from a by linear least squares, a is scanned. Returns a, B, D of the local minima of the
/// grid, best first, at most `options.starts`. [fit.md F4]
std::vector<Start> search_grid(const FitProblem& problem, const FitOptions& options);

}  // namespace skylut::fit_detail
