#include "skylut/sky/sun_appearance.hpp"

#include "skylut/sky/sun_disc.hpp"

namespace skylut {

namespace {

// The sky, and the disc by what it sends.
SunAppearance appearance(const ColourMatching& matching, const SunIrradiance& sun,
                         const Xyz& disc_illuminance, double visible_solid_angle_sr) {
  const PlanckianLocus locus(matching);
  SunAppearance result;
  result.disc = light_colour(locus, disc_illuminance);
  if (visible_solid_angle_sr > 0.0) result.mean_luminance_cd_m2 = disc_illuminance.Y / visible_solid_angle_sr;
  if (!sun.diffuse_horizontal.empty())
    result.sky = light_colour(locus, matching.integrate(sun.wavelengths, sun.diffuse_horizontal));
  return result;
}

}  // namespace

std::optional<LightColour> light_colour(const PlanckianLocus& locus, const Xyz& illuminance) {
  if (!(illuminance.Y > 0.0)) return std::nullopt;
  const Yxy colour = to_yxy(illuminance);
  return LightColour{illuminance.Y, colour.x, colour.y, locus.nearest(colour), to_linear_srgb(illuminance)};
}

SunAppearance sun_appearance(const Context& context, const SunIrradiance& sun, const SunDisc& disc) {
  SunAppearance result =
      appearance(ColourMatching::load(context), sun, disc.illuminance(), disc.visible_solid_angle_sr());
  result.angular_diameter_deg = 2.0 * disc.angular_radius_deg();
  result.visible_part = disc.visible_part();
  return result;
}

SunAppearance sun_appearance(const Context& context, const SunIrradiance& sun, double sun_distance_au) {
  const ColourMatching matching = ColourMatching::load(context);
  const double solid_angle_sr = sun.beam_arrives ? sun_solid_angle_sr(sun_distance_au) : 0.0;
  SunAppearance result =
      appearance(matching, sun, matching.integrate(sun.wavelengths, sun.direct_normal), solid_angle_sr);
  result.angular_diameter_deg = 2.0 * sun_angular_radius_deg(sun_distance_au);
  result.visible_part = sun.beam_arrives ? 1.0 : 0.0;
  return result;
}

}  // namespace skylut
