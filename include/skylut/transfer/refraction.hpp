#pragma once

#include "skylut/scattering/optical_column.hpp"

// How the air's refraction shows the sun and the horizon to one observer. A zenith angle is TRUE where
// nothing but geometry counts (ephemerides, fields of light by the sun's place) and APPARENT where it is seen
// (views, pictures, the scattering angle). Shells without refractivity bend nothing: both are the same.
// [docs/refraction.md]

namespace skylut {

/// The sun of one true zenith angle.
struct ApparentSun {
  double zenith_deg = 0.0;  ///< apparent; of a hidden sun, lifted as the last that is not
  bool hidden = false;      ///< by the ground
  /// Light on a plane normal to the beam over what it would be without the spreading by refraction, the way's
  /// absorption apart; also the disc's apparent solid angle over the true one. 0.83 on the horizon. (0, 5]
  double concentration = 1.0;
};

/// Bending is integrated to 1e-5 of itself through air whose refractivity is exponential between levels.
/// @param altitude_km      of the observer, 0 to the top
/// @param sun_zenith_deg  true, [0, 180]
/// @throws InputError  for values out of range, or air that traps rays
ApparentSun apparent_sun(const Shells& shells, double altitude_km, double sun_zenith_deg);

/// True zenith angle of a sun that is seen at an apparent one; below the horizon as apparent_sun lifts it.
double true_sun_zenith_deg(const Shells& shells, double altitude_km, double apparent_zenith_deg);

/// True zenith angle of the last sun that the ground does not hide: 90.55 deg on the ground.
double last_sun_zenith_deg(const Shells& shells, double altitude_km);

/// Shells and observer among which lines of sight are straight in apparent directions: radius n r for r.
/// Panels, horizon and tangents of a picture follow from them as from straight rays. Shells without
/// refractivity are returned as they are.
Shells apparent_shells(const Shells& shells);
double apparent_altitude_km(const Shells& shells, double altitude_km);

}  // namespace skylut
