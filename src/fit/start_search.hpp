#pragma once

#include <vector>

#include "fit_problem.hpp"

namespace skylut::fit_detail {

/// A node of the search's grid that is lower than its neighbours, and its cost.
struct GridMinimum {
  double cost = 0.0;
  LinearParameters at{};
};

/// Looks over a grid of B and D. At each node the linear form leaves a, c, e, in which the model is bilinear:
/// c and e follow from a by linear least squares, a is scanned. Returns the local minima of the grid, best
/// first, at most `options.starts`. [fit.md F4]
std::vector<GridMinimum> search_grid(const FitProblem& problem, const FitOptions& options);

}  // namespace skylut::fit_detail
