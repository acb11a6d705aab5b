#pragma once

#include <vector>

namespace skylut {

/// Generalised spherical functions d^l_mn(μ) (Wigner's d; Gelfand & Shapiro 1952; Hovenier & van der Mee
/// 1983, doi:10.1007/978-94-009-8473-8), by their recurrence in l. d^l_m0 = Λ_lm of core/legendre.hpp.
/// d^2_02 = √6/4 (1-μ²), d^2_22 = (1+μ)²/4, d^2_2,-2 = (1-μ)²/4: positive where l is least.
/// @param m      >= 0
/// @param n      any sign
/// @param max_l  highest degree
/// @param mu     cosine, [-1, 1]
/// @return l = max(m, |n|) … max_l; empty if max_l is less
std::vector<double> generalised_legendre(int m, int n, int max_l, double mu);

}  // namespace skylut
