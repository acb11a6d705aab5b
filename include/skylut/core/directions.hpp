#pragma once

#include <string>
#include <vector>

namespace skylut {

/// A direction of view or of the sun: zenith angle from the local vertical, azimuth clockwise
/// from north.
struct Direction {
  double zenith_deg = 0.0;   ///< 0 = straight up, 90 = astronomical horizon, up to 180
  double azimuth_deg = 0.0;  ///< [0, 360)

  bool operator==(const Direction&) const = default;
};

/// The 271 directions of the UTM report: the zenith, then 9 rings (10°…90° zenith) of 30
/// azimuths (0°, 12°, … 348°), rings from the zenith down. (UTM report 2005 §3.3.2, Fig. 3.5.)
std::vector<Direction> directions_utm271();

/// 343 directions as the count of Preetham et al. 1999 §4 (their layout is not published): the
/// zenith, then 19 rings of 18 azimuths, ring i at the zenith angle that gives every direction
/// the same solid angle of the hemisphere.
std::vector<Direction> directions_preetham343();

/// Angle between two directions, radians, in [0, π]; accurate near 0 and π (haversine form).
double angle_between(const Direction& a, const Direction& b);

/// The same azimuth in [0, 360). @param azimuth_deg  finite
double wrapped_azimuth_deg(double azimuth_deg);

/// |azimuth difference| folded to [0, 180] degrees and rounded to 1e-9°, so that mirror-symmetric
/// views of the sun are recognised as equal.
double folded_relative_azimuth_deg(double azimuth_deg, double sun_azimuth_deg);

/// One view relative to the sun, as the radiative transfer needs it.
struct RelativeView {
  double zenith_deg = 0.0;            ///< [0, 180]
  double relative_azimuth_deg = 0.0;  ///< [0, 180], 0 = towards the sun

  auto operator<=>(const RelativeView&) const = default;
};

}  // namespace skylut
