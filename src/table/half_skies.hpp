#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "skylut/models/perez.hpp"

namespace skylut::table_detail {

/// A dome's directions as Perez formulas take them, for one sun: ring by ring.
class FormulaDome {
 public:
  explicit FormulaDome(double sun_zenith_rad);

  /// F(θ,γ)/F(0,θ_s) in every direction. [direction]
  std::vector<double> relative(const PerezCoefficients& k) const;

 private:
  struct Ring {
    double cos_zenith;
    std::vector<double> gamma_rad;
  };
  double sun_zenith_rad_;
  std::vector<Ring> rings_;
};

/// How far the sky of halved coefficients lies from between the skies of the two rows, over the dome: mean
/// square of ln F_half - ½ (ln F_1 + ln F_2), each relative to its zenith.
/// @param half   dome of the sun between theirs
/// @param ln_one, ln_other  logarithms of their relative skies
/// @param limit  beyond which a direction counts as no sky's, with 1e5, like one in which the half is not
///               positive
double half_misfit(const FormulaDome& half, const PerezCoefficients& one, const std::vector<double>& ln_one,
                   const PerezCoefficients& other, const std::vector<double>& ln_other, double limit);

/// From here on a half_misfit has a direction that no sky has.
inline constexpr double kImpossibleHalf = 800.0;

}  // namespace skylut::table_detail
