#pragma once

#include <cstddef>
#include <span>

namespace skylut {

/// Bernstein's polynomials of one degree, by which Bézier curves are the weighted mean of their control
/// points: b_j(x) = C(n, j) x^j (1 - x)^(n-j). They are not negative and sum to 1, so that a curve stays
/// between the least and the greatest of its points.
/// @param x      [0, 1]
/// @param basis  [degree + 1], filled
inline void bernstein_basis(double x, std::span<double> basis) {
  // Row by row of de Casteljau's triangle.
  basis[0] = 1.0;
  for (std::size_t degree = 1; degree < basis.size(); ++degree) {
    basis[degree] = x * basis[degree - 1];
    for (std::size_t j = degree - 1; j > 0; --j) basis[j] = x * basis[j - 1] + (1.0 - x) * basis[j];
    basis[0] *= 1.0 - x;
  }
}

}  // namespace skylut
