#pragma once

#include "sky_quadrature.hpp"
#include "skylut/sky/sun_irradiance.hpp"

namespace skylut {

/// Which part of what a plane faces.
enum class PlanePart {
  sky,    ///< above the horizontal
  ground  ///< below it: the ground and the air before it
};

/// ∫ L max(0, cos i) dΩ over one part of the sphere, i the angle of incidence on a tilted plane. Pieces in
/// zenith angle between the sun's, the horizon's and those where the plane's own edge touches a circle of
/// equal zenith angle; in azimuth between the sun's vertical plane and the plane's edge; within each of them
/// Gauss-Legendre nodes t at t² (3 - 2t), which crowd at both ends, where radiance peaks or weights bend.
/// Directions that the plane does not face are left out. Accuracy: 3e-5 for a smooth sky, 2e-3 for a
/// Henyey-Greenstein aureole of g = 0.95 and 1e-4 for 0.85 (tests/unit/sky/plane_quadrature_test.cpp).
/// @param sun                 at the observer, zenith angle [0, 180]
/// @param horizon_zenith_deg  of the geometric horizon, [90, 180)
SkyQuadrature plane_quadrature(const TiltedPlane& plane, PlanePart part, const Direction& sun,
                               double horizon_zenith_deg);

/// cos i of light from a direction, [-1, 1]; negative from behind.
double cos_incidence(const TiltedPlane& plane, const Direction& from);

}  // namespace skylut
