#pragma once

#include <string>

#include "skylut/sky/refracted_sun.hpp"
#include "skylut/sky/sun_appearance.hpp"
#include "skylut/sky/sun_irradiance.hpp"

namespace skylut {

/// Sums over the wavelengths, W/m² and lux, a line for each kind of light; then those on a plane, if there is
/// one.
std::string sun_sums_text(const SunIrradiance& sun);

/// Where the sun is and where it is seen, how much its disc is flattened; nothing for straight light.
std::string refracted_sun_text(const std::optional<RefractedSun>& sun);

/// The disc's size and luminance, then the colours of the sun's and the sky's light, a line for each.
std::string sun_appearance_text(const SunAppearance& appearance);

/// Irradiances and transmittances in some twenty lines: every wavelength of a coarse grid, a choice of a fine
/// one.
std::string sun_spectrum_text(const SunIrradiance& sun);

}  // namespace skylut
