#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "skylut/fit/fit_perez.hpp"

/// The search for the least cost of any formula, which comes as a local search in its parameters.
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

/// Runs one local search: from where, to what tolerance, with how many iterations at most.
using Search = std::function<Minimum(const Start&, double tolerance, int iterations)>;

/// Short runs from every start, thorough ones from the best different ends. [fit.md F5]
/// @param within  ends whose cost is up to this share above the best are followed too, two in any case
/// @return different minima, the least first; empty if no start has a cost
std::vector<Minimum> multistart(const Search& search, const std::vector<Start>& starts, int max_iterations,
                                double within);

}  // namespace skylut::fit_detail
