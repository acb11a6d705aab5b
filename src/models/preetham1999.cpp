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

}  // namespace

Yxy preetham1999_zenith_kcd_m2(double turbidity, double sun_zenith_rad) {
  const double T = turbidity;
  const double chi = (4.0 / 9.0 - T / 120.0) * (kPi - 2.0 * sun_zenith_rad);
  return {(4.0453 * T - 4.9710) * std::tan(chi) - 0.2155 * T + 2.4192,
          zenith_chromaticity(kZenith_x, T, sun_zenith_rad),
          zenith_chromaticity(kZenith_y, T, sun_zenith_rad)};
}

const ModelInfo& Preetham1999::info() const {
  static const ModelInfo info{.name = "preetham1999",
                              .title = "Preetham, Shirley, Smits 1999",
                              .source = "doi:10.1145/311535.311545",
                              .quantities = "Y, x, y",
                              .altitude_km = {0.0, 0.0, "km"},
                              .turbidity_kind = TurbidityKind::preetham_t,
                              .turbidity = {2.0, 6.0, ""},
                              .sun_zenith_deg = {0.0, 90.0, "deg"},
                              .view_zenith_deg = {0.0, 90.0, "deg"}};
  return info;
}

std::unique_ptr<const Sky> Preetham1999::at(const SkyConditions& conditions) const {
  const double T = conditions.turbidity.value;
  if (conditions.turbidity.kind != info().turbidity_kind)
    throw InputError("Preetham 1999: turbidity of kind {}: must be preetham-t",
                     turbidity_kind_name(conditions.turbidity.kind));
  if (!(T >= 1.0) || !std::isfinite(T))
    throw InputError("Preetham 1999: turbidity T = {}: must be at least 1", T);
  require_within("Preetham 1999: altitude", conditions.altitude_km, info().altitude_km);
  require_within("Preetham 1999: sun zenith angle", conditions.sun.zenith_deg, info().sun_zenith_deg);
  Yxy zenith = preetham1999_zenith_kcd_m2(T, conditions.sun.zenith_deg * kRadiansPerDegree);
  zenith.Y *= 1000.0;
  return std::make_unique<const PerezSky>(preetham1999_coefficients(T), zenith, conditions.sun);
}

}  // namespace skylut
