#pragma once

#include "skylut/core/constants.hpp"
#include "skylut/fit/fit_sky.hpp"
#include "skylut/sky/sky_map.hpp"

namespace skylut {

/// Coefficients of the made-up skies: Preetham's at turbidity 2.25 or so, rounded.
inline const PerezCoefficients kMadeUp_Y{-1.06, -0.3, 5.8, -2.6, 0.4};
inline const PerezCoefficients kMadeUp_x{-0.06, -0.25, 0.12, -1.0, 0.1};
inline const PerezCoefficients kMadeUp_y{-0.08, -0.3, 0.15, -1.3, 0.08};

/// A sky that is exactly three Perez formulas.
inline SkyMap perez_map(double altitude_km, const Direction& sun) {
  SkyMap map;
  map.altitude_km = altitude_km;
  map.turbidity = {TurbidityKind::aod500, 0.5};
  map.sun = sun;
  map.directions = directions_utm271();
  for (const Direction& view : map.directions)
    map.colour.push_back(perez_sky(kMadeUp_Y, kMadeUp_x, kMadeUp_y, {3500.0, 0.25, 0.26},
                                   view.zenith_deg * kRadiansPerDegree, angle_between(view, sun),
                                   sun.zenith_deg * kRadiansPerDegree));
  return map;
}

}  // namespace skylut
