#include "skylut/models/preetham1999.hpp"

#include <array>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using Cubic = std::array<double, 4>;  // of θ_s: θ³, θ², θ, 1

// [T² T 1] M [θ³ θ² θ 1].
double zenith_chromaticity(const std::array<Cubic, 3>& rows, double T, double theta) {
  const auto value = [theta](const Cubic& c) {
    return ((c[0] * theta + c[1]) * theta + c[2]) * theta + c[3];
  };
  return (value(rows[0]) * T + value(rows[1])) * T + value(rows[2]);
}

constexpr std::array<Cubic, 3> kZenith_x{{{0.0017, -0.0037, 0.0021, 0.000},
                                          {-0.0290, 0.0638, -0.0320, 0.0039},
                                          {0.1169, -0.2120, 0.0605, 0.2589}}};
constexpr std::array<Cubic, 3> kZenith_y{{{0.0028, -0.0061, 0.0032, 0.000},
                                          {-0.0421, 0.0897, -0.0415, 0.0052},
                                          {0.1535, -0.2676, 0.0667, 0.2669}}};

void check_above_horizon(const char* what, const Direction& direction) {
  if (!(direction.zenith_deg >= 0.0 && direction.zenith_deg <= 90.0))
    throw InputError("Preetham 1999: {} zenith angle {}°: must lie within 0-90°", what, direction.zenith_deg);
}

}  // namespace

Yxy preetham1999_zenith_kcd_m2(double turbidity, double sun_zenith_rad) {
  const double T = turbidity;
  const double chi = (4.0 / 9.0 - T / 120.0) * (kPi - 2.0 * sun_zenith_rad);
  return {(4.0453 * T - 4.9710) * std::tan(chi) - 0.2155 * T + 2.4192,
          zenith_chromaticity(kZenith_x, T, sun_zenith_rad),
          zenith_chromaticity(kZenith_y, T, sun_zenith_rad)};
}

Yxy preetham1999(double turbidity, const Direction& sun, const Direction& view) {
  const double sun_zenith = sun.zenith_deg * kRadiansPerDegree;
  const PerezYxy k = preetham1999_coefficients(turbidity);
  Yxy zenith = preetham1999_zenith_kcd_m2(turbidity, sun_zenith);
  zenith.Y *= 1000.0;
  return perez_sky(k.Y, k.x, k.y, zenith, view.zenith_deg * kRadiansPerDegree, angle_between(view, sun),
                   sun_zenith);
}

Preetham1999::Preetham1999(double turbidity) : turbidity_(turbidity) {
  if (!(turbidity >= 1.0) || !std::isfinite(turbidity))
    throw InputError("Preetham 1999: turbidity T = {}: must be at least 1", turbidity);
}

Yxy Preetham1999::sky(const Direction& sun, const Direction& view) const {
  check_above_horizon("sun", sun);
  check_above_horizon("view", view);
  if (view.zenith_deg == 90.0 && preetham1999_coefficients(turbidity_).Y.B >= 0.0)
    throw InputError(
        "Preetham 1999: turbidity T = {}: must be above 1.203 for a view at the horizon, infinite below",
        turbidity_);
  return preetham1999(turbidity_, sun, view);
}

}  // namespace skylut
