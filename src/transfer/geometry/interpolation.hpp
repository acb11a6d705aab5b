#pragma once

#include <cstdint>
#include <vector>

namespace skylut::transfer {

/// Four neighbouring nodes and their weights: f(x) ≈ Σ weight[i] f(node[first + i]).
struct InterpolationWeights {
  std::int32_t first = 0;
  float weight[4] = {};
};

/// Cubic Lagrange interpolation among at least four ascending nodes.
class CubicInterpolation {
 public:
  explicit CubicInterpolation(const std::vector<double>& nodes);

  /// Outside the nodes x is taken at the nearest one.
  InterpolationWeights operator()(double x) const;

 private:
  struct Stencil {
    double node[4];
    double inverse_denominator[4];  // 1/Π (node_i - node_other)
  };
  std::vector<Stencil> stencil_;  // by first node
  double lowest_;
  double highest_;
  double cells_per_unit_;
  std::vector<double> nodes_;
  std::vector<int> node_below_;  // of the start of every cell: no search among many nodes
};

}  // namespace skylut::transfer
