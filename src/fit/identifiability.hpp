#pragma once

#include <Eigen/Core>
#include <vector>

namespace skylut::fit_detail {

/// How well data fix one coefficient of a formula.
struct Identifiability {
  double standard_error = 0.0;  ///< infinity if a combination that changes no residual moves it
  bool determined = false;      ///< careful errors move it by less than its size
};

/// What the judgement needs, at the minimum; n residuals, p parameters of the fit, p coefficients.
struct FitAtMinimum {
  Eigen::MatrixXd jacobian;                 ///< n × p: d residual / d parameter
  Eigen::MatrixXd coefficient_derivatives;  ///< p × p: d coefficient / d parameter
  std::vector<double> coefficients;         ///< p
  double variance = 0.0;                    ///< of a residual, 2 cost / (n - p)
  double careful_variance = 0.0;            ///< the same, no less than the accuracy of any data
};

/// Standard errors and determinacy from the singular values of the Jacobian with its columns scaled to equal
/// length: the rank must not depend on the units of the parameters. [fit.md F6]
/// @return one per coefficient
std::vector<Identifiability> identifiability(const FitAtMinimum& fit);

}  // namespace skylut::fit_detail
