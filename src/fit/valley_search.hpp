#pragma once

#include <vector>

#include "fit_problem.hpp"

namespace skylut::fit_detail {

/// A starting point and its cost.
struct Valley {
  double cost = 0.0;
  LinearParameters start{};
};

/// Looks over a grid of B and D. At each node the linear form leaves a, c, e, in which the model is bilinear:
/// c and e follow from a by linear least squares, a is scanned. Returns the local minima of the grid, best
/// first, at most `count`. [fit.md F4]
std::vector<Valley> search_valleys(const FitProblem& problem, const FitOptions& options, int count);

}  // namespace skylut::fit_detail
