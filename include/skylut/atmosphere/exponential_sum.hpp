#pragma once

#include <vector>

namespace skylut {

/// One exponential of a sum T(u) = Σ weight exp(-coefficient u): a part of a band and how strongly it
/// absorbs.
struct Exponential {
  double weight = 1.0;       ///< part of the band, [0, 1]; those of a sum add up to 1
  double coefficient = 0.0;  ///< >= 0, the inverse of the amount's unit
};

/// Σ weight exp(-coefficient amount).
double transmittance(const std::vector<Exponential>& sum, double amount);

/// A few exponentials, three at most, that stand for many. A term is one more lane of the solver: a band
/// has as few as keep the transmittance of m vertical amounts within 0.005 (1 + m / 2), m = 0.05 to 40
/// (twice that before a third term is taken; 0.05 where lines are black, since no term is blacker
/// than a vertical depth of 3). Weighted least squares, coefficients from a logarithmic grid, weights > 0
/// with sum 1. [docs/air.md §10, A24]
///
/// @param sum              weights >= 0 with sum 1, coefficients >= 0
/// @param vertical_amount  of the whole atmosphere, >= 0
/// @return one to three terms, ascending coefficients; the same for the same input, always
std::vector<Exponential> fit_exponentials(const std::vector<Exponential>& sum, double vertical_amount);

}  // namespace skylut
