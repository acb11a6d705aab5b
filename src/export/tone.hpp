#pragma once

#include "skylut/colour/yxy.hpp"

/// From light to what a screen shows; see Preview.
namespace skylut {

/// Reinhard et al. 2002 eq. 4.
class ToneCurve {
 public:
  /// @param grey_cd_m2   > 0: becomes 0.18 before the curve
  /// @param white_cd_m2  becomes 1
  ToneCurve(double grey_cd_m2, double white_cd_m2);

  /// Luminance on the screen, 0 to 1, 1 being its white.
  double operator()(double luminance_cd_m2) const;

 private:
  double scale_;
  double white_;
};

struct DisplayedColour {
  LinearRgb rgb;        ///< Rec. 709, every channel within 0 to 1
  double change = 0.0;  ///< largest, of a channel, by mixing with white
};

/// Light as the curve shows it, of the same chromaticity where Rec. 709 has it at that luminance; else mixed
/// with white of that luminance, no more than needed.
DisplayedColour displayed(const Xyz& light, const ToneCurve& curve);

/// The sRGB encoding, IEC 61966-2-1:1999 eqs. 2 and 3. @param linear  [0, 1]
double srgb_encoded(double linear);

}  // namespace skylut
