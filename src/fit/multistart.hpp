#pragma once

#include <ceres/cost_function.h>

#include <limits>
#include <string>
#include <vector>

#include "skylut/fit/fit_perez.hpp"

/// The search for the least cost of any formula: the only place that runs Ceres's solver. A formula comes as
/// a cost function of the parameters that are searched (perez_form.hpp is one).
namespace skylut::fit_detail {

/// Values of the searched parameters from which a search begins.
using Start = std::vector<double>;

/// Where a searched parameter may lie.
struct ParameterBounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Where a search ended.
struct Minimum {
  double cost = std::numeric_limits<double>::infinity();
  std::vector<double> at;  ///< the searched parameters
  Termination termination = Termination::not_run;
  std::string message;
  int iterations = 0;
};

/// A short Levenberg-Marquardt run from every start, a thorough one from the two best ends. [fit.md F5]
/// @param residuals  of one block of parameters; returns false, never a number that is not finite, where it
/// has
///                   no value: Ceres would print a warning
/// @param bounds     one per parameter; starts outside are moved to the bound
/// @param max_iterations  per run
/// @return the least; cost infinity if no start has a cost
Minimum multistart(ceres::CostFunction& residuals, const std::vector<ParameterBounds>& bounds,
                   const std::vector<Start>& starts, int max_iterations);

}  // namespace skylut::fit_detail
