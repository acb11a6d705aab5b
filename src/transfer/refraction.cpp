#include "skylut/transfer/refraction.hpp"

#include <cmath>

#include "geometry/sun_refraction.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "spherical/request_check.hpp"

namespace skylut {

using transfer::RefractiveShells;
using transfer::SunRefraction;

namespace {

double geometric_horizon_deg(const Shells& shells, double altitude_km) {
  const double tangent_km = std::sqrt(altitude_km * (2.0 * shells.planet_radius_km + altitude_km));
  return 90.0 + std::atan(tangent_km / shells.planet_radius_km) * kDegreesPerRadian;
}

}  // namespace

ApparentSun apparent_sun(const Shells& shells, double altitude_km, double sun_zenith_deg) {
  transfer::check_place(shells, altitude_km, sun_zenith_deg);
  if (shells.refractivity.empty())
    return {sun_zenith_deg, sun_zenith_deg > geometric_horizon_deg(shells, altitude_km), 1.0};
  const RefractiveShells air(shells);
  const SunRefraction refraction(air, SunRefraction::Bending::integrated);
  const double sun = sun_zenith_deg * kRadiansPerDegree;
  return {refraction.apparent_sun_rad(altitude_km, sun) * kDegreesPerRadian,
          sun > refraction.last_sun_rad(altitude_km),
          refraction.sunbeam(altitude_km, std::cos(sun)).concentration};
}

double true_sun_zenith_deg(const Shells& shells, double altitude_km, double apparent_zenith_deg) {
  transfer::check_place(shells, altitude_km, apparent_zenith_deg);
  if (shells.refractivity.empty()) return apparent_zenith_deg;
  const RefractiveShells air(shells);
  return SunRefraction(air, SunRefraction::Bending::integrated)
             .true_sun_rad(altitude_km, apparent_zenith_deg * kRadiansPerDegree) *
         kDegreesPerRadian;
}

double last_sun_zenith_deg(const Shells& shells, double altitude_km) {
  transfer::check_place(shells, altitude_km, 0.0);
  if (shells.refractivity.empty()) return geometric_horizon_deg(shells, altitude_km);
  const RefractiveShells air(shells);
  return SunRefraction(air, SunRefraction::Bending::integrated).last_sun_rad(altitude_km) * kDegreesPerRadian;
}

Shells apparent_shells(const Shells& shells) {
  if (shells.refractivity.empty()) return shells;
  const RefractiveShells air(shells);
  return {air.optical().levels_km(), air.optical().planet_radius_km(), {}};
}

double apparent_altitude_km(const Shells& shells, double altitude_km) {
  return shells.refractivity.empty() ? altitude_km : RefractiveShells(shells).optical_km(altitude_km);
}

}  // namespace skylut
