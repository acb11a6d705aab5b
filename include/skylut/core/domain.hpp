#pragma once

#include <cstddef>

#include "skylut/core/errors.hpp"

/// What skylut computes for: every limit of an input stands here, once, and every check and message takes
/// it from here.
namespace skylut {

/// A closed interval of allowed values, with its unit for messages ("km"; "" for a pure number).
struct Range {
  double lowest = 0.0;
  double highest = 0.0;
  const char* unit = "";

  constexpr bool holds(double value) const { return value >= lowest && value <= highest; }
};

namespace domain {

inline constexpr Range kObserver_km{0.0, 30.0, "km"};  ///< altitude above the ground
/// With diffuse light: far into nautical twilight. At 99° the shadow over the zenith is 80 km high.
inline constexpr Range kSunZenith_deg{0.0, 99.0, "deg"};
inline constexpr Range kAnyZenith_deg{0.0, 180.0, "deg"};  ///< of a view, or of a sun without diffuse light
inline constexpr Range kAzimuth_deg{-3600.0, 3600.0, "deg"};  ///< as typed: ten turns either way
inline constexpr Range kFold_deg{0.0, 180.0, "deg"};          ///< an azimuth difference, folded
inline constexpr Range kWavelength_nm{300.0, 1000.0, "nm"};
inline constexpr Range kBand_nm{0.01, 100.0, "nm"};  ///< width of a band
inline constexpr double kMostWavelengths = 10001;
inline constexpr Range kTurbidityValue{0.0, 1e6, ""};  ///< of any kind; the kind may narrow it
inline constexpr Range kAlbedo{0.0, 1.0, ""};
inline constexpr Range kOzone_DU{0.0, 1000.0, "DU"};
inline constexpr Range kNitrogenDioxide_DU{0.0, 100.0, "DU"};
inline constexpr Range kWater_cm{0.0, 20.0, "cm"};
inline constexpr Range kSurfacePressure_hPa{300.0, 1100.0, "hPa"};
inline constexpr Range kGravity_m_s2{9.7, 9.9, "m/s2"};
inline constexpr Range kHumidity_percent{0.0, 99.0, "%"};
inline constexpr Range kGroundHeight_m{-500.0, 9000.0, "m"};  ///< of the ground above the ellipsoid
/// Radiances at 1000 km are within 0.4 % of Monte Carlo (sun at 60°, 9 directions from the zenith to 89.9°);
/// at 100 km they were +0.3 to +1.6 % off.
inline constexpr Range kPlanetRadius_km{1000.0, 1e9, "km"};
inline constexpr Range kLevel_km{0.0, 1e4, "km"};            ///< of a layer, above the ground
inline constexpr Range kCircumsolar_deg{0.0, 10.0, "deg"};   ///< half angle of the cone around the sun
inline constexpr Range kTilt_deg{0.0, 180.0, "deg"};         ///< of a plane from the horizontal
inline constexpr Range kDiscSpacing_deg{0.002, 1.0, "deg"};  ///< of the points that stand for the solar disc
inline constexpr Range kThreads{0.0, 1024.0, ""};            ///< 0: one per core
inline constexpr Range kPictureSize_pixels{2.0, 16384.0, ""};  ///< height, or edge of a square
inline constexpr Range kMiddleGrey_cd_m2{1e-9, 1e9, "cd/m2"};  ///< of a preview
inline constexpr std::size_t kMostFrames = 100'000;            ///< of a series of suns
inline constexpr Range kPhotons{1.0, 1e12, ""};                ///< of the Monte Carlo solver, per direction
inline constexpr Range kSeed{0.0, 9007199254740992.0, ""};     ///< whole numbers that a double holds: to 2^53
inline constexpr Range kScatteringOrders{0.0, 1e5, ""};        ///< 0: all
inline constexpr Range kAbsorptionTerm{1.0, 1e6, ""};          ///< of a band, counted from 1
inline constexpr Range kSizeParameter{1e-6, 1e5, ""};          ///< of a sphere: circumference over wavelength
inline constexpr int kMostScatteringAngles = 100'000;
inline constexpr Range kAngstromExponent{-1.0, 4.2,
                                         ""};  ///< small clear spheres scatter more steeply than λ^-4
inline constexpr std::size_t kLargestInput_bytes = 256'000'000;  ///< of a TOML or JSON file
inline constexpr std::size_t kLongestLine_bytes = 1'000'000;     ///< of a comma-separated file
inline constexpr std::size_t kDeepestNesting = 64;               ///< of a JSON file; a solver case has 4
inline constexpr double kAtmosphereTop_km = 100.0;               ///< that every profile reaches
inline constexpr double kLowestProfileTop_km = 10.0;  ///< a file's last level: continued from there on

}  // namespace domain

/// @throws InputError  "what value unit: must lie within lowest to highest unit"
inline void require_within(const char* what, double value, const Range& range) {
  if (range.holds(value)) return;
  const char* const space = *range.unit == '\0' ? "" : " ";
  throw InputError("{} {}{}{}: must lie within {} to {}{}{}", what, value, space, range.unit, range.lowest,
                   range.highest, space, range.unit);
}

}  // namespace skylut
