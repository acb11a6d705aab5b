#pragma once

#include <array>
#include <cmath>

#include "skylut/models/perez.hpp"

/// The Perez formula relative to its zenith, rewritten so that it is linear in three of its parameters and
/// has none of the poles at F(0, θ_s) = 0 that split the landscape of A…E into valleys. [fit.md F3]
///
///   F(θ,γ)/F(0,θ_s) = (1 + a U(θ;B)) (1 + c W(γ;D) + e K(γ))
///   U = e^{B (1/cosθ - 1)} - 1,  W = (e^{D (γ-γ₀)} - e^{D (θ_s-γ₀)})/D,  K = cos²γ - cos²θ_s
///
/// with γ₀ the smallest γ of the data, which keeps W of the order of 1.
namespace skylut::fit_detail {

/// The sun as the linear form needs it.
struct SunFrame {
  double sun_zenith_rad = 0.0;
  double cos2_sun_zenith = 1.0;
  double gamma_0_rad = 0.0;
};

/// Parameters a, B, c, D, e in the order of A, B, C, D, E.
using LinearParameters = std::array<double, 5>;

/// (e^{x} - 1)/x, finite at 0. Below 1e-4 the series, off by x³/24 < 5e-14.
template <class T>
T expm1_over(const T& x) {
  using std::abs;
  using std::expm1;
  return abs(x) < 1e-4 ? T(1.0) + 0.5 * x + x * x / 6.0 : T(expm1(x) / x);
}

/// U for the airmass-like excess 1/cosθ - 1; infinity at the horizon, where U is its limit -1.
template <class T>
T gradation_basis(const T& B, double secant_excess) {
  using std::expm1;
  return std::isinf(secant_excess) ? T(-1.0) : T(expm1(B * secant_excess));
}

template <class T>
T aureole_basis(const T& D, double gamma_rad, const SunFrame& sun) {
  using std::exp;
  const double away = gamma_rad - sun.sun_zenith_rad;
  return exp(D * (sun.sun_zenith_rad - sun.gamma_0_rad)) * expm1_over(T(D * away)) * away;
}

/// A…E of the linear form's parameters: A = a e^{-B}/(1-a); with p = 1 - c e^{D (θ_s-γ₀)}/D - e cos²θ_s,
/// C = c e^{-D γ₀}/(D p), E = e/p.
template <class T>
std::array<T, 5> to_perez(const std::array<T, 5>& linear, const SunFrame& sun) {
  using std::exp;
  const auto& [a, B, c, D, e] = linear;
  const T p = 1.0 - c * exp(D * (sun.sun_zenith_rad - sun.gamma_0_rad)) / D - e * sun.cos2_sun_zenith;
  return {T(a * exp(-B) / (1.0 - a)), B, T(c * exp(-D * sun.gamma_0_rad) / (D * p)), D, T(e / p)};
}

/// The inverse; not finite where F(0, θ_s) = 0.
inline LinearParameters to_linear(const PerezCoefficients& k, const SunFrame& sun) {
  const double gradation = 1.0 + k.A * std::exp(k.B);
  const double scattering = 1.0 + k.C * std::exp(k.D * sun.sun_zenith_rad) + k.E * sun.cos2_sun_zenith;
  return {k.A * std::exp(k.B) / gradation, k.B, k.C * k.D * std::exp(k.D * sun.gamma_0_rad) / scattering, k.D,
          k.E / scattering};
}

}  // namespace skylut::fit_detail
