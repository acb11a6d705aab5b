#include "scattering_rotation.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

ScatteringRotation scattering_rotation(double view_zenith_deg, double relative_azimuth_deg,
                                       double sun_zenith_deg) {
  const double view = view_zenith_deg * kRadiansPerDegree;
  const double azimuth = relative_azimuth_deg * kRadiansPerDegree;
  const double sun = sun_zenith_deg * kRadiansPerDegree;
  // The sun's direction across the line of sight: in its vertical plane, downwards, and towards growing
  // azimuth. Both lie in the plane of scattering, whose angle to the vertical is therefore theirs.
  const double along = std::cos(view) * std::sin(sun) * std::cos(azimuth) - std::sin(view) * std::cos(sun);
  const double across = -std::sin(sun) * std::sin(azimuth);
  const double square = along * along + across * across;  // sin²Θ
  if (square < 1e-24) return {};                          // F12 is 0 there
  return {(along * along - across * across) / square, -2.0 * along * across / square};
}

}  // namespace skylut::transfer
