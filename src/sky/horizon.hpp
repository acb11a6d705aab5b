#pragma once

namespace skylut {

struct Shells;

/// Zenith angle of the geometric horizon: 90° on the ground, more from a height. On its visible side by far
/// more than rounding, so that a ray there misses the ground. @param altitude_km  above the ground, >= 0
double horizon_zenith_deg(double planet_radius_km, double altitude_km);

/// Apparent zenith angle of the horizon, which refraction lifts where the shells have a refractivity.
double horizon_zenith_deg(const Shells& shells, double altitude_km);

}  // namespace skylut
