#pragma once

#include <vector>

#include "skylut/core/directions.hpp"

namespace skylut {

/// Directions that sample a dome from the zenith to its horizon, each with the part of it that it stands for.
struct DomeDirections {
  std::vector<Direction> directions;    ///< the first is the zenith
  std::vector<double> solid_angles_sr;  ///< together the dome's
};

/// What a Perez formula is fitted to: rings that leave nothing of the dome unseen, dense towards the horizon
/// (80°, 82°, … 89.5°, 89.9°, 90°) and around the sun from 0.5° to 8°; azimuths on the sun's one side, where
/// the other is its mirror image. Some 390 directions; 28 with the sun at the zenith. [fit.md D1]
/// @param sun                 zenith angle [0, 180]
/// @param horizon_zenith_deg  [90, 180): where the rings end; those of a dome that ends at 90° are stretched
DomeDirections dome_directions(const Direction& sun, double horizon_zenith_deg = 90.0);

/// What its errors are found with: another, finer set, whose rings and azimuths lie between those of the
/// first: 4° apart in zenith angle, 0.5° and less in the last 10°, 15° in azimuth, and closer around the sun.
/// Some 640 directions. [fit.md D2]
DomeDirections dome_check_directions(const Direction& sun, double horizon_zenith_deg = 90.0);

/// How much more a direction counts than its solid angle where the horizon is emphasised: 1 at the zenith, 2
/// at 75°, 3 at 90°. [fit.md D3]
double horizon_emphasis(double zenith_rad);

}  // namespace skylut
