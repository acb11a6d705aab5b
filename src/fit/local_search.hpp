#pragma once

#include <Eigen/Core>

#include "aureole.hpp"
#include "fit_problem.hpp"
#include "multistart.hpp"

namespace skylut::fit_detail {

/// Levenberg-Marquardt for the Perez formula in ln(1-a), ln(-B) and D, with c and e eliminated: what
/// PerezForm's residuals say, written out for speed. The valleys along which a and B trade are straight in
/// these logarithms, and a < 1, so that the gradation stays positive. Its derivatives leave out how the
/// eliminated space turns (Kaufman 1975), which costs no accuracy of the gradient. [fit.md F5]
class LocalSearch {
 public:
  /// Both arguments must outlive the search.
  LocalSearch(const FitProblem& problem, const FitOptions& options);

  /// @param start       a, B, D; moved into the bounds
  /// @param tolerance   of the cost, relative, that further steps may still gain
  /// @param iterations  at most
  Minimum run(const Start& start, double tolerance, int iterations);

 private:
  struct Point {
    double log_level;  // ln(1-a): of the horizon relative to the zenith, as the gradation has it
    double log_rate;   // ln(-B)
    double D;
  };
  struct Local {
    double cost;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d curvature;  // JᵀJ
  };

  Point within_bounds(const Point& point) const;
  double cost_at(const Point& point);
  /// Of the point that cost_at() was asked for last.
  Local local_here() const;
  void eliminate(double D);

  const FitProblem& problem_;
  const FitOptions& options_;
  Point lower_;
  Point upper_;
  double least_offset_;  // of p; 0: any
  Eigen::ArrayXd h_, t_, K_, away_;
  // Of the last point: gradation and its derivative by ln(-B) per ring and observation; columns.
  Eigen::ArrayXd ring_excess_, ring_U_, ring_slope_, U_, U_slope_;
  Eigen::ArrayXd level_, w_, k_, base_, residual_;
  Aureole aureole_;
  double a_ = 0.0, c_ = 0.0, e_ = 0.0;
  double c_D_ = 0.0, e_D_ = 0.0;  // how c and e follow D where p is held
  bool held_ = false;
  bool has_k_ = false, has_w_ = false;
};

}  // namespace skylut::fit_detail
