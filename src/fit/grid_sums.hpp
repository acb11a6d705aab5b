#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit_problem.hpp"

namespace skylut::fit_detail {

/// The sums over the observations that a node (B, D) of the search's grid needs: with g = 1 + a U and the
/// columns h g {1, W, K}, every inner product is a polynomial in a. h: model scale, t: target.
struct NodeSums {
  // Of h² U^i times 1, W, K, W², WK, K²; i = 0, 1, 2.
  double one[3], W[3], K[3], WW[3], WK[3], KK[3];
  // Of h t U^i times 1, W, K; i = 0, 1.
  double t_one[2], t_W[2], t_K[2];
  double t_t;
};

/// The sums of all nodes: inner products of every U^i with every function of W at once, as matrix products.
class GridSums {
 public:
  /// @param rates   values of B
  /// @param widths  values of D
  GridSums(const FitProblem& problem, const std::vector<double>& rates, const std::vector<double>& widths);

  NodeSums at(Eigen::Index rate, Eigen::Index width) const;

 private:
  // Rates × widths, and rates.
  Eigen::MatrixXd W_[3], WW_[3], WK_[3], tW_[2];
  Eigen::VectorXd one_[3], K_[3], KK_[3], t_[2], tK_[2];
  double t_t_ = 0.0;
};

}  // namespace skylut::fit_detail
