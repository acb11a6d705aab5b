#pragma once

#include <vector>

namespace skylut {

/// One step of Bonnet's recurrence: P_{l+1}(x) from P_l and P_{l-1} with `part` = 1/(l+1), which is the same
/// for all x. P_0 = 1; P_{-1} may be anything finite.
inline double next_legendre(double part, double x, double current, double previous) {
  return (2.0 - part) * x * current - (1.0 - part) * previous;
}

/// Normalised associated Legendre functions Λ_lm(μ) = √((l-m)!/(l+m)!) P_lm(μ) for one m and l = m … max_l,
/// without the Condon-Shortley sign, so that (addition theorem)
///   P_l(cosΘ) = Σ_m (2-δ_m0) Λ_lm(μ) Λ_lm(μ') cos m(φ-φ').
/// The normalisation keeps them within ±1. Three-term recurrence in l (Dave & Armstrong 1970). [theory.md M2]
/// @param m      >= 0
/// @param max_l  >= m
/// @param mu     in [-1, 1]
std::vector<double> normalised_legendre(int m, int max_l, double mu);

}  // namespace skylut
