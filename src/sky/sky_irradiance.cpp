#include "skylut/sky/sky_irradiance.hpp"

#include "sky_quadrature.hpp"

namespace skylut {

std::vector<double> diffuse_horizontal(const SkyLight& sky) {
  return integrate(sky, hemisphere_quadrature(sky.sun().zenith_deg));
}

Xyz diffuse_horizontal_illuminance(const SkyLight& sky) {
  return integrate_colour(sky, hemisphere_quadrature(sky.sun().zenith_deg));
}

}  // namespace skylut
