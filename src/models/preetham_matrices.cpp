#include "skylut/models/preetham_matrices.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

PerezCoefficients at(const PreethamMatrices::Perez& linear, double T) {
  return {linear[0].at(T), linear[1].at(T), linear[2].at(T), linear[3].at(T), linear[4].at(T)};
}

// [T² T 1] M [θ³ θ² θ 1].
double zenith_chromaticity(const PreethamMatrices::Chromaticity& rows, double T, double theta) {
  const auto value = [theta](const PreethamMatrices::Cubic& c) {
    return ((c[0] * theta + c[1]) * theta + c[2]) * theta + c[3];
  };
  return (value(rows[0]) * T + value(rows[1])) * T + value(rows[2]);
}

}  // namespace

PerezYxy PreethamMatrices::coefficients(double turbidity) const {
  return {at(Y, turbidity), at(x, turbidity), at(y, turbidity)};
}

Yxy PreethamMatrices::zenith_kcd_m2(double turbidity, double sun_zenith_rad) const {
  const double T = turbidity;
  const double chi = (zenith_Y.chi_offset - T / zenith_Y.chi_divisor) * (kPi - 2.0 * sun_zenith_rad);
  return {zenith_Y.tangent.at(T) * std::tan(chi) + zenith_Y.rest.slope * T + zenith_Y.rest.offset,
          zenith_chromaticity(zenith_x, T, sun_zenith_rad), zenith_chromaticity(zenith_y, T, sun_zenith_rad)};
}

const PreethamMatrices& preetham1999_matrices() {
  static constexpr PreethamMatrices kMatrices{
      .Y = {{{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}}},
      .x =
          {{{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}}},
      .y =
          {{{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}}},
      .zenith_Y = {.tangent = {4.0453, -4.9710}, .rest = {-0.2155, 2.4192}},
      .zenith_x = {{{0.0017, -0.0037, 0.0021, 0.000},
                    {-0.0290, 0.0638, -0.0320, 0.0039},
                    {0.1169, -0.2120, 0.0605, 0.2589}}},
      .zenith_y = {{{0.0028, -0.0061, 0.0032, 0.000},
                    {-0.0421, 0.0897, -0.0415, 0.0052},
                    {0.1535, -0.2676, 0.0667, 0.2669}}}};
  return kMatrices;
}

}  // namespace skylut
