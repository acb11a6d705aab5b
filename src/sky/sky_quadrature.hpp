#pragma once

#include <vector>

#include "skylut/core/directions.hpp"
#include "skylut/sky/sky_light.hpp"

namespace skylut {

/// Directions with weights: Σ weight · radiance is an irradiance per unit of radiance, sr. Directions on one
/// side of the sun's vertical plane stand for both.
struct SkyQuadrature {
  std::vector<RelativeView> views;
  std::vector<double> weight;
};

/// Σ weight · radiance of a sky, per wavelength, W m⁻² nm⁻¹; or of its colours.
std::vector<double> integrate(const SkyLight& sky, const SkyQuadrature& quadrature);
Xyz integrate_colour(const SkyLight& sky, const SkyQuadrature& quadrature);

/// ∫ L cosθ dΩ over the upper hemisphere. Nodes crowd around the sun, where haze is bright: on either side of
/// the sun's zenith angle θ_s they stand at θ_s ± span · t², in azimuth at 180° · t², t by Gauss and
/// Legendre. Accuracy: 0.1 % of the diffuse irradiance (tests/unit/sky/sun_irradiance_test.cpp).
/// @param sun_zenith_deg  [0, 180]
SkyQuadrature hemisphere_quadrature(double sun_zenith_deg);

/// ∫ L cosγ dΩ over the cone of that half angle around the sun, on a plane normal to the beam.
/// @param half_angle_deg  (0, 10]
SkyQuadrature circumsolar_quadrature(double sun_zenith_deg, double half_angle_deg);

}  // namespace skylut
