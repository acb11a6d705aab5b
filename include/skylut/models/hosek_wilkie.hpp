#pragma once

#include <array>
#include <cmath>
#include <span>

#include "skylut/core/constants.hpp"

namespace skylut {

/// The nine coefficients of Hosek and Wilkie's formula, A to I in the order of kHosekWilkieNames.
using HosekWilkieCoefficients = std::array<double, 9>;
inline constexpr std::array<const char*, 9> kHosekWilkieNames{"A", "B", "C", "D", "E", "F", "G", "H", "I"};

/// χ(g, α) = (1 + cos²α)/(1 + g² - 2 g cosα)^(3/2): forward scattering whose width is free. Hvězda 2020
/// eq. 2.16 prints it without the exponent; Hosek and Wilkie 2012 eq. 9 has it. [models.md]
/// @param g  (-1, 1)
inline double anisotropic_term(double g, double cos_gamma) {
  const double distance2 = 1.0 + g * g - 2.0 * g * cos_gamma;
  return (1.0 + cos_gamma * cos_gamma) / (distance2 * std::sqrt(distance2));
}

/// F(θ, γ) = (1 + A e^{B/(cosθ + 0.01)}) (C + D e^{Eγ} + F cos²γ + G χ(H, γ) + I √cosθ). Hosek and Wilkie
/// 2012 eq. 8 (doi:10.1145/2185520.2185591), Hvězda 2020 eq. 2.15; at and below the horizon that of the
/// horizon.
inline double hosek_wilkie(std::span<const double, 9> c, double cos_zenith, double gamma_rad,
                           double cos_gamma) {
  const double height = std::fmax(cos_zenith, 0.0);
  const double gradation = 1.0 + c[0] * std::exp(c[1] / (height + 0.01));
  return gradation * (c[2] + c[3] * std::exp(c[4] * gamma_rad) + c[5] * cos_gamma * cos_gamma +
                      c[6] * anisotropic_term(c[7], cos_gamma) + c[8] * std::sqrt(height));
}

/// Where along their Bézier curves the coefficients of a sun lie: the cube root of its elevation over 90°, so
/// that low suns, under which skies change fastest, have most of the curve. [Hvězda 2020 eq. 2.19]
/// @param sun_zenith_deg  [0, 90]
inline double hosek_wilkie_curve_parameter(double sun_zenith_deg) {
  return std::cbrt(std::fmax(0.0, 1.0 - sun_zenith_deg / 90.0));
}

}  // namespace skylut
