#pragma once

#include <vector>

namespace skylut::transfer {

/// Four neighbouring nodes and their weights: f(x) ≈ Σ weight[i] f(node[first + i]).
struct Taps {
  int first = 0;
  float weight[4] = {};
};

/// Cubic Lagrange interpolation at x among at least four ascending nodes. Outside the nodes x is taken
/// at the nearest one.
Taps cubic_taps(const std::vector<double>& nodes, double x);

}  // namespace skylut::transfer
