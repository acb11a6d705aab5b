#pragma once

#include "skylut/models/sky_model.hpp"
#include "skylut/models/preetham_coefficients.hpp"

namespace skylut {

/// The sky model of Preetham, Shirley and Smits 1999: its appendix A.2, both halves. The coefficients are
/// preetham1999_coefficients() of fit/preetham_coefficients.hpp. [fit.md P1-P3]

/// Turbidities that the model was fitted to (its §4: simulations for T from 2 to 6).
inline constexpr double kPreethamLowestTurbidity = 2.0;
inline constexpr double kPreethamHighestTurbidity = 6.0;

/// Zenith colour, Y in kcd/m². The formulas take any turbidity and sun, but are polynomials meant for T from
/// 2 to 6: for T = 1, luminance is negative with the sun within 12.9° of the zenith.
/// @param sun_zenith_rad  [0, π/2]
Yxy preetham1999_zenith_kcd_m2(double turbidity, double sun_zenith_rad);

/// Colour of the sky, Y in cd/m².
/// @param sun, view  zenith angles within 0-90°
Yxy preetham1999(double turbidity, const Direction& sun, const Direction& view);

/// The model as a sky of one turbidity.
class Preetham1999 final : public SkyModel {
 public:
  /// @throws InputError unless the turbidity is finite and at least 1 (1: air without aerosol)
  explicit Preetham1999(double turbidity);

  /// @throws InputError unless sun and view have zenith angles within 0-90°, and at the horizon for T
  /// below 1.203,
  ///         where B_Y > 0 and the formula is infinite
  Yxy sky(const Direction& sun, const Direction& view) const override;

 private:
  double turbidity_;
};

}  // namespace skylut
