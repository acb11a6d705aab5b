#pragma once

#include <array>
#include <string>
#include <vector>

#include "skylut/colour/yxy.hpp"

namespace skylut {

struct Chromaticity {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const Chromaticity&) const = default;
};

/// A space of linear (scene-referred) RGB, by the chromaticities of its primaries and its white: R = G = B =
/// 1 is the white with Y = 1.
struct RgbSpace {
  std::string name;               ///< of the option --rgb-space
  std::string colour_interop_id;  ///< of the Color Interop Forum, for the OpenEXR attribute colorInteropID
  Chromaticity red;
  Chromaticity green;
  Chromaticity blue;
  Chromaticity white;
};

/// rec709       ITU-R BT.709-6 (2015) item 1.3, white D65
/// rec2020      ITU-R BT.2020-2 (2015) table 3, white D65
/// p3           primaries of SMPTE RP 431-2:2011 (DCI-P3), white D65: SMPTE EG 432-1:2010
/// acescg       AP1, Academy S-2014-004, white of ACES (near D60)
/// aces2065-1   AP0, SMPTE ST 2065-1:2021 table 1, white of ACES
const std::vector<RgbSpace>& rgb_spaces();

/// @throws InputError  if the name is none of theirs
const RgbSpace& rgb_space(const std::string& name);

/// What becomes of D65 light in a space whose white is another (the ACES spaces).
enum class WhiteAdaptation {
  /// Bradford's (Lam 1985; as CIE 159:2004 lists it), linear, from D65 to the space's white: light of D65 is
  /// R = G = B, so that a picture looks the same after a program with ACES colour management (OpenColorIO's
  /// ACES configurations, Blender, OpenEXR's ImfAcesFile) has turned it into Rec. 709, which they do by
  /// Bradford's adaptation too.
  bradford,
  /// The light's own tristimulus values in the primaries: D65 is bluish.
  none
};

/// From CIE XYZ to one space and back, with matrices derived from the chromaticities in full precision
/// (SMPTE RP 177:1993). Colours outside the space are negative, never clamped.
class RgbConversion {
 public:
  explicit RgbConversion(const RgbSpace& space, WhiteAdaptation adaptation = WhiteAdaptation::bradford);

  LinearRgb to_rgb(const Xyz& colour) const;
  Xyz to_xyz(const LinearRgb& colour) const;

  /// Y = r R + g G + b B.
  LinearRgb luminance_weights() const;

 private:
  std::array<std::array<double, 3>, 3> to_xyz_;
  std::array<std::array<double, 3>, 3> to_rgb_;
};

}  // namespace skylut
