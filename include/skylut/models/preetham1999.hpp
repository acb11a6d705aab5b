#pragma once

#include "skylut/models/preetham_coefficients.hpp"
#include "skylut/models/sky_model.hpp"

namespace skylut {

/// Zenith colour of Preetham, Shirley and Smits 1999, appendix A.2, Y in kcd/m². The formulas take any
/// turbidity and sun, but are polynomials meant for T from 2 to 6: for T = 1, luminance is negative with the
/// sun within 12.9° of the zenith. [fit.md P2]
/// @param sun_zenith_rad  [0, π/2]
Yxy preetham1999_zenith_kcd_m2(double turbidity, double sun_zenith_rad);

/// The sky model of Preetham, Shirley and Smits 1999: its appendix A.2, both halves. For an observer on the
/// ground; turbidity T, simulated for 2 to 6 (its §4), computed from 1 on (1: air without aerosol). [fit.md
/// P1-P3]
class Preetham1999 final : public SkyModel {
 public:
  const ModelInfo& info() const override;

  /// @return a PerezSky
  /// @throws InputError  unless altitude is 0, the turbidity is T and finite and at least 1, and the sun's
  /// zenith
  ///                     angle lies within 0-90°. The sky refuses the horizon for T below 1.203, where B_Y >
  ///                     0 and the formula is infinite.
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;
};

}  // namespace skylut
