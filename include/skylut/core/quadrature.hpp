#pragma once

#include <vector>

namespace skylut {

/// Nodes and weights of a quadrature rule: ∫ f dx ≈ Σ weight[i] f(node[i]).
struct Quadrature {
  std::vector<double> node;
  std::vector<double> weight;
};

/// Gauss-Legendre rule with `count` >= 1 nodes on [lower, upper], nodes ascending; exact for
/// polynomials up to degree 2 count - 1. Newton iteration on P_n (Abramowitz & Stegun 25.4.29-30).
Quadrature gauss_legendre(int count, double lower, double upper);

}  // namespace skylut
