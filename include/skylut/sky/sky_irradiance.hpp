#pragma once

#include <vector>

#include "skylut/sky/sky_light.hpp"

namespace skylut {

/// Diffuse light from above on a horizontal plane, ∫ L cosθ dΩ, W m⁻² nm⁻¹, per wavelength: some 500
/// directions, which crowd around the sun. Accuracy: 0.1 % (tests/unit/sky/sun_irradiance_test.cpp).
std::vector<double> diffuse_horizontal(const SkyLight& sky);

/// The same as CIE 1931 tristimulus values, lux.
Xyz diffuse_horizontal_illuminance(const SkyLight& sky);

}  // namespace skylut
