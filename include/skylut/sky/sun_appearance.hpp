#pragma once

#include <optional>

#include "skylut/colour/colour_temperature.hpp"
#include "skylut/colour/yxy.hpp"
#include "skylut/sky/sun_irradiance.hpp"

namespace skylut {

struct Context;
class SunDisc;

/// An illuminance and its colour.
struct LightColour {
  double illuminance_lux = 0.0;
  double x = kD65_x;  ///< CIE 1931
  double y = kD65_y;
  std::optional<ColourTemperature> temperature;  ///< none for what is far from every black body
  LinearRgb rgb;  ///< primaries of Rec. 709, white D65, in lux: a white light has r = g = b = its illuminance
};

/// What the eye, or a picture, makes of the light of simulate_sun.
struct SunAppearance {
  double angular_diameter_deg = 0.0;
  double visible_part = 0.0;          ///< of the disc's solid angle, [0, 1]; the ground hides the rest
  double mean_luminance_cd_m2 = 0.0;  ///< of the part that is visible
  std::optional<LightColour> disc;    ///< normal to the beam; none: no such light
  std::optional<LightColour> sky;     ///< diffuse, on a horizontal plane; none: dark, or not computed
};

/// The colour of an illuminance; nothing for darkness.
/// @param illuminance  CIE 1931 tristimulus values, lux
std::optional<LightColour> light_colour(const PlanckianLocus& locus, const Xyz& illuminance);

/// @param disc  of the scene that the irradiance was simulated for
SunAppearance sun_appearance(const Context& context, const SunIrradiance& sun, const SunDisc& disc);

/// The same for a direct beam that is known by its irradiance alone, spread evenly over the whole disc.
SunAppearance sun_appearance(const Context& context, const SunIrradiance& sun, double sun_distance_au);

}  // namespace skylut
