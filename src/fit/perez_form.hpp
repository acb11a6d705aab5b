#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fit_problem.hpp"
#include "linear_form.hpp"
#include "multistart.hpp"

namespace skylut::fit_detail {

/// The Perez formula as the search sees it: residuals in a, B, D, with c and e eliminated. [fit.md F3-F5]
/// Another formula is another class like this.
class PerezForm {
 public:
  /// Both arguments must outlive the form.
  PerezForm(const FitProblem& problem, const FitOptions& options);

  /// The best places of a search over B and D, and Preetham's coefficients of Y, x and y.
  std::vector<Start> starts() const;
  /// Goes on by Newton's method, with automatic derivatives, from where the search stopped short.
  Minimum search_on(Minimum from) const;
  /// a, B, c, D, e for searched a, B, D.
  LinearParameters all_parameters(std::span<const double> searched) const;
  /// Derivatives of the residuals by a, B, c, D, e: observations × 5.
  Eigen::MatrixXd jacobian(const LinearParameters& at) const;
  /// d(A…E)/d(a, B, c, D, e).
  Eigen::MatrixXd coefficient_derivatives(const LinearParameters& at) const;

 private:
  const FitProblem& problem_;
  const FitOptions& options_;
};

}  // namespace skylut::fit_detail
