#pragma once

#include <string>

#include "skylut/sky/sun_appearance.hpp"
#include "skylut/sky/sun_irradiance.hpp"

namespace skylut {

/// CSV: a line of column names, then one line per wavelength. Columns wavelength_nm, direct_normal_w_m2_nm,
/// diffuse_horizontal_w_m2_nm, global_horizontal_w_m2_nm (these two only with diffuse light),
/// extraterrestrial_w_m2_nm, circumsolar_normal_w_m2_nm and, on a plane, plane_direct_w_m2_nm,
/// plane_sky_w_m2_nm, plane_ground_w_m2_nm and plane_global_w_m2_nm (if asked for), then
/// transmittance_<constituent>.
std::string sun_csv(const SunIrradiance& sun);

/// JSON: the same lists by name, with how they were made, the sums over the wavelengths, and under "disc" and
/// "sky" what the light looks like.
/// @param scene   that the irradiance was computed for
/// @param method  "shells" or the name of a closed-form model
std::string sun_json(const SunIrradiance& sun, const SunAppearance& appearance, const SkyScene& scene,
                     const std::string& method, const Provenance& provenance);

}  // namespace skylut
