#include "skylut/sky/refracted_sun.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/sky/sun_disc.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut {

std::optional<RefractedSun> refracted_sun(const SkyScene& scene) {
  if (!scene.atmosphere) return std::nullopt;
  const Atmosphere& air = *scene.atmosphere;
  if (air.shells().refractivity.empty()) return std::nullopt;
  const double altitude_km = scene.altitudes_km.at(0);
  const double sun_deg = scene.suns.at(0).zenith_deg;
  const auto refraction_deg = [&](double wavelength_nm) {
    return sun_deg - apparent_sun(air.shells_at(wavelength_nm), altitude_km, sun_deg).zenith_deg;
  };
  RefractedSun sun;
  sun.true_zenith_deg = sun_deg;
  sun.blue_refraction_deg = refraction_deg(450.0);
  sun.refraction_deg = refraction_deg(550.0);
  sun.red_refraction_deg = refraction_deg(650.0);
  sun.apparent_zenith_deg = sun_deg - sun.refraction_deg;
  sun.last_zenith_deg = last_sun_zenith_deg(air.shells(), altitude_km);
  const double radius_deg = sun_angular_radius_deg(scene.sun_distance_au);
  const auto seen_deg = [&](double zenith_deg) {
    return zenith_deg <= 0.0
               ? zenith_deg
               : apparent_sun(air.shells(), altitude_km, std::min(zenith_deg, 180.0)).zenith_deg;
  };
  const double top_deg = std::min(sun_deg - radius_deg, sun.last_zenith_deg);
  const double bottom_deg = std::min(sun_deg + radius_deg, sun.last_zenith_deg);
  sun.vertical_diameter_deg = seen_deg(bottom_deg) - seen_deg(top_deg);
  // Along its almucantar the disc keeps its azimuths.
  const double sine = std::sin(sun_deg * kRadiansPerDegree);
  const double shrinks = sine > 0.0 ? std::sin(sun.apparent_zenith_deg * kRadiansPerDegree) / sine : 1.0;
  sun.horizontal_diameter_deg = 2.0 * radius_deg * shrinks;
  return sun;
}

}  // namespace skylut
