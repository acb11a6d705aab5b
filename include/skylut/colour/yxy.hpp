#pragma once

namespace skylut {

/// CIE 1931 tristimulus values. As skylut uses them: X, Y, Z in cd/m², so that Y is the luminance.
struct Xyz {
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  bool operator==(const Xyz&) const = default;
};

/// Luminance (any unit, kept as given) and CIE 1931 chromaticity.
struct Yxy {
  double Y = 0.0;
  double x = 0.0;
  double y = 0.0;

  bool operator==(const Yxy&) const = default;
};

/// Linear (not gamma-encoded) light in the primaries of an RGB space, in the unit of the tristimulus values;
/// negative where a colour lies outside the gamut, never clamped.
struct LinearRgb {
  double r = 0.0;
  double g = 0.0;
  double b = 0.0;

  bool operator==(const LinearRgb&) const = default;
};

/// Chromaticity of the sRGB white, CIE illuminant D65 (IEC 61966-2-1:1999 table 1).
inline constexpr double kD65_x = 0.3127;
inline constexpr double kD65_y = 0.3290;

/// x = X/(X+Y+Z), y = Y/(X+Y+Z) (CIE 15:2004 eq. 7.3). Black, X+Y+Z = 0, has no chromaticity: it is
/// given that of D65, so that a map of a dark sky holds numbers and turns back into black.
Yxy to_yxy(const Xyz& colour);

/// X = x Y/y, Z = (1 - x - y) Y/y; black for Y = 0, whatever x and y.
/// @throws InputError if Y is not 0 and y is 0: no such light
Xyz to_xyz(const Yxy& colour);

/// Linear RGB in the primaries of IEC 61966-2-1 (those of ITU-R BT.709) and white D65, Y = 1 for
/// r = g = b = 1. The matrix is derived from the chromaticities in full precision; the standard prints
/// it to 4 digits, and the UTM report 2005 Fig. 4.10 to 6. [fit.md C4]
LinearRgb to_linear_srgb(const Xyz& colour);

/// The inverse of to_linear_srgb(Xyz), exact to rounding.
Xyz to_xyz(const LinearRgb& colour);

}  // namespace skylut
