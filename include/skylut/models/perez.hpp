#pragma once

#include <array>
#include <cmath>

#include "skylut/colour/yxy.hpp"

namespace skylut {

/// The five coefficients of the Perez formula (Perez, Seals, Michalsky 1993), dimensionless; γ in radians.
struct PerezCoefficients {
  double A = 0.0;  ///< darkening or brightening of the horizon
  double B = 0.0;  ///< gradient near the horizon; < 0, or the formula is infinite there
  double C = 0.0;  ///< intensity of the region around the sun
  double D = 0.0;  ///< its width, 1/rad
  double E = 0.0;  ///< light scattered backwards

  bool operator==(const PerezCoefficients&) const = default;
  std::array<double, 5> values() const { return {A, B, C, D, E}; }
};

/// Names of the coefficients, in the order of PerezCoefficients::values().
inline constexpr std::array<const char*, 5> kPerezNames{"A", "B", "C", "D", "E"};

/// F(θ, γ) = (1 + A e^{B/cosθ}) (1 + C e^{Dγ} + E cos²γ)  [Preetham et al. 1999 eq. 3; fit.md F1]
/// At and below the horizon, cosθ <= 1e-12, e^{B/cosθ} is its limit for B < 0, which is 0.
/// @param cos_zenith  cosine of the view's zenith angle
/// @param gamma_rad   angle between view and sun, [0, π]
/// @param cos_gamma   its cosine
template <class T>
T perez(const T& A, const T& B, const T& C, const T& D, const T& E, double cos_zenith, double gamma_rad,
        double cos_gamma) {
  using std::exp;
  constexpr double kHorizon = 1e-12;
  const T gradation = cos_zenith > kHorizon ? T(1.0) + A * exp(B / cos_zenith) : T(1.0);
  return gradation * (T(1.0) + C * exp(D * gamma_rad) + E * (cos_gamma * cos_gamma));
}

inline double perez(const PerezCoefficients& c, double zenith_rad, double gamma_rad) {
  return perez(c.A, c.B, c.C, c.D, c.E, std::cos(zenith_rad), gamma_rad, std::cos(gamma_rad));
}

/// F(θ, γ) / F(0, θ_s): the sky relative to its zenith. Not finite where F(0, θ_s) = 0.
inline double perez_relative(const PerezCoefficients& c, double zenith_rad, double gamma_rad,
                             double sun_zenith_rad) {
  return perez(c, zenith_rad, gamma_rad) / perez(c, 0.0, sun_zenith_rad);
}

/// Three Perez formulas and a zenith colour as a sky for the one sun they were fitted for.
/// @return Y in the unit of `zenith`
Yxy perez_sky(const PerezCoefficients& Y, const PerezCoefficients& x, const PerezCoefficients& y,
              const Yxy& zenith, double view_zenith_rad, double gamma_rad, double sun_zenith_rad);

}  // namespace skylut
