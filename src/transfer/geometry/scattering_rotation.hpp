#pragma once

namespace skylut::transfer {

/// Turns Q of singly scattered sunlight from the plane of scattering into the vertical plane of the line of
/// sight: of F12, Q = F12 q and U = F12 u. Both planes are the same all along a straight ray.
/// [docs/polarisation.md P3]
struct ScatteringRotation {
  double q = 1.0;
  double u = 0.0;
};

/// @param view_zenith_deg, relative_azimuth_deg  where the observer looks, azimuth from the sun's; at the
///     zenith the vertical plane is that of the azimuth
ScatteringRotation scattering_rotation(double view_zenith_deg, double relative_azimuth_deg,
                                       double sun_zenith_deg);

}  // namespace skylut::transfer
