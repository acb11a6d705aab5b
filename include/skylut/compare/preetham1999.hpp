#pragma once

#include "skylut/colour/sky_model.hpp"
#include "skylut/fit/perez.hpp"

namespace skylut {

/// The sky model of Preetham, Shirley and Smits 1999, appendix A.2: both halves. [fit.md P1-P3]
struct Preetham1999Coefficients {
  PerezCoefficients Y;
  PerezCoefficients x;
  PerezCoefficients y;
};

/// Turbidities that the model was fitted to (its §4: simulations for T from 2 to 6).
inline constexpr double kPreethamLowestTurbidity = 2.0;
inline constexpr double kPreethamHighestTurbidity = 6.0;

/// Perez coefficients, linear in turbidity T. The UTM report's eqs. 2.20-2.21 lose the signs of A_x, D_x, D_y.
Preetham1999Coefficients preetham1999_coefficients(double turbidity);

/// Zenith colour, Y in kcd/m². Defined for any turbidity and sun, but luminance turns negative where the
/// formula leaves its range (low T with a high sun).
Yxy preetham1999_zenith_kcd_m2(double turbidity, double sun_zenith_rad);

/// Colour of the sky, Y in cd/m².
Yxy preetham1999(double turbidity, const Direction& sun, const Direction& view);

/// The model as a sky of one turbidity; sun and view above the horizon (zenith angle 0-90°).
class Preetham1999 final : public SkyModel {
 public:
  /// @throws InputError unless the turbidity is finite and at least 1 (1: air without aerosol)
  explicit Preetham1999(double turbidity);
  Yxy sky(const Direction& sun, const Direction& view) const override;

 private:
  double turbidity_;
};

}  // namespace skylut
