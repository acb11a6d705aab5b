#pragma once

#include <array>

#include "skylut/models/perez_sky.hpp"

namespace skylut {

/// Every number of a sky model after Preetham, Shirley and Smits 1999, appendix A.2; theirs are one set,
/// those that skylut fits to its own skies are others. [fit.md P1-P2]
struct PreethamMatrices {
  /// slope T + offset
  struct Linear {
    double slope = 0.0;
    double offset = 0.0;
    double at(double turbidity) const { return slope * turbidity + offset; }
    bool operator==(const Linear&) const = default;
  };
  using Perez = std::array<Linear, 5>;  ///< A to E
  /// Y_z = (tangent) tan χ + (rest) in kcd/m², χ = (chi_offset - T/chi_divisor) (π - 2θ_s)
  struct ZenithLuminance {
    double chi_offset = 4.0 / 9.0;
    double chi_divisor = 120.0;
    Linear tangent;
    Linear rest;
    bool operator==(const ZenithLuminance&) const = default;
  };
  using Cubic = std::array<double, 4>;        ///< of θ_s: θ³, θ², θ, 1
  using Chromaticity = std::array<Cubic, 3>;  ///< by T², T, 1

  Perez Y;
  Perez x;
  Perez y;
  ZenithLuminance zenith_Y;
  Chromaticity zenith_x{};
  Chromaticity zenith_y{};

  bool operator==(const PreethamMatrices&) const = default;

  PerezYxy coefficients(double turbidity) const;

  /// @param sun_zenith_rad  [0, π/2]
  Yxy zenith_kcd_m2(double turbidity, double sun_zenith_rad) const;
};

/// The published ones. The UTM report 2005, eqs. 2.20-2.21, loses the signs of A_x, D_x and D_y.
const PreethamMatrices& preetham1999_matrices();

}  // namespace skylut
