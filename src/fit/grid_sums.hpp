#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit_problem.hpp"

namespace skylut::fit_detail {

/// One number for every D of the search's grid; on the stack.
constexpr int kMostWidths = 128;
using OverWidths = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMostWidths, 1>;

/// The sums over the observations that the nodes (B, D) of one B of the search's grid need: with g = 1 + a U
/// and the columns h g {1, W, K}, every inner product is a polynomial in a. h: model scale, t: target. Arrays
/// run over D.
struct RateSums {
  // Of h² U^i times 1, K, K², W, W², WK; i = 0, 1, 2.
  double one[3], K[3], KK[3];
  OverWidths W[3], WW[3], WK[3];
  // Of h t U^i times 1, K, W; i = 0, 1.
  double t_one[2], t_K[2];
  OverWidths t_W[2];
  double t_t;
};

/// The sums of all nodes. U depends on the ring alone: what depends on γ is summed over each ring once.
class GridSums {
 public:
  /// @param rates   values of B
  /// @param widths  values of D
  GridSums(const FitProblem& problem, const std::vector<double>& rates, const std::vector<double>& widths);

  RateSums at(Eigen::Index rate) const;

 private:
  // Widths × rates, and rates.
  Eigen::MatrixXd W_[3], WW_[3], WK_[3], tW_[2];
  Eigen::VectorXd one_[3], K_[3], KK_[3], t_[2], tK_[2];
  double t_t_ = 0.0;
};

}  // namespace skylut::fit_detail
