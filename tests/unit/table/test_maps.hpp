#pragma once

#include "skylut/core/constants.hpp"
#include "skylut/fit/dome_directions.hpp"
#include "skylut/fit/fit_sky.hpp"
#include "skylut/sky/view_set.hpp"
#include "skylut/table/fit_table.hpp"

namespace skylut {

/// Coefficients of the made-up skies: Preetham's at turbidity 2.25 or so, rounded.
inline const PerezCoefficients kMadeUp_Y{-1.06, -0.3, 5.8, -2.6, 0.4};
inline const PerezCoefficients kMadeUp_x{-0.06, -0.25, 0.12, -1.0, 0.1};
inline const PerezCoefficients kMadeUp_y{-0.08, -0.3, 0.15, -1.3, 0.08};
inline const Yxy kMadeUpZenith{3500.0, 0.25, 0.26};

/// A sky that is exactly three Perez formulas, with their horizon at `horizon_deg`.
inline TableSky perez_table_sky(double altitude_km, const Direction& sun,
                                const PerezCoefficients& Y = kMadeUp_Y, double horizon_deg = 90.0) {
  TableSky sky;
  sky.altitude_km = altitude_km;
  sky.turbidity = {TurbidityKind::aod500, 0.5};
  sky.sun = sun;
  sky.dome_ends_deg = horizon_deg;
  const auto seen = [&](const DomeDirections& dome) {
    SampledSky sampled;
    for (const Direction& view : dome.directions) {
      sampled.views.push_back(relative_view(view, sun));
      sampled.colour.push_back(perez_sky(Y, kMadeUp_x, kMadeUp_y, kMadeUpZenith,
                                         view.zenith_deg * (90.0 / horizon_deg) * kRadiansPerDegree,
                                         angle_between(view, sun), sun.zenith_deg * kRadiansPerDegree));
    }
    sampled.solid_angles_sr = dome.solid_angles_sr;
    return sampled;
  };
  sky.fitted = seen(dome_directions(sun, horizon_deg));
  sky.check = seen(dome_check_directions(sun, horizon_deg));
  return sky;
}

}  // namespace skylut
