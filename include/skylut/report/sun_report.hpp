#pragma once

#include <string>

#include "skylut/sky/sun_irradiance.hpp"

namespace skylut {

/// Sums over the wavelengths, W/m² and lux, a line for each kind of light.
std::string sun_sums_text(const SunIrradiance& sun);

/// Irradiances and transmittances in some twenty lines: every wavelength of a coarse grid, a choice of a fine
/// one.
std::string sun_spectrum_text(const SunIrradiance& sun);

}  // namespace skylut
