#pragma once

#include <optional>

#include "skylut/sky/sky_scene.hpp"

namespace skylut {

/// What refraction does to the sun's disc before an observer, in degrees.
struct RefractedSun {
  double true_zenith_deg = 0.0;          ///< of its centre
  double apparent_zenith_deg = 0.0;      ///< the same as it is seen at 550 nm; of a hidden sun, lifted as the
                                         ///< last that is not
  double last_zenith_deg = 0.0;          ///< true, of the last sun that the ground does not hide
  double blue_refraction_deg = 0.0;      ///< true less apparent zenith angle, at 450 nm
  double refraction_deg = 0.0;           ///< 550 nm
  double red_refraction_deg = 0.0;       ///< 650 nm: the disc's red edge is this much lower than its blue one
  double vertical_diameter_deg = 0.0;    ///< apparent, of the whole disc or what stands above the horizon
  double horizontal_diameter_deg = 0.0;  ///< apparent
};

/// @param scene  with one altitude and one sun
/// @return       nothing where the scene's air does not bend light
std::optional<RefractedSun> refracted_sun(const SkyScene& scene);

}  // namespace skylut
