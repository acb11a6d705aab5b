#include "horizon.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/transfer/refraction.hpp"

namespace skylut {

double horizon_zenith_deg(double planet_radius_km, double altitude_km) {
  if (altitude_km == 0.0) return 90.0;
  constexpr double kVisibleSide_deg = 1e-9;
  const double tangent_km = std::sqrt(altitude_km * (2.0 * planet_radius_km + altitude_km));
  return 90.0 + std::atan(tangent_km / planet_radius_km) * kDegreesPerRadian - kVisibleSide_deg;
}

double horizon_zenith_deg(const Shells& shells, double altitude_km) {
  return horizon_zenith_deg(apparent_shells(shells).planet_radius_km,
                            apparent_altitude_km(shells, altitude_km));
}

}  // namespace skylut
