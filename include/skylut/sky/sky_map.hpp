#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/colour/yxy.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/wavelength_grid.hpp"

namespace skylut {

/// The diffuse light (no solar disc) that one observer sees under one sun, in many directions.
struct SkyMap {
  double altitude_km = 0.0;  ///< of the observer, above the ground
  Turbidity turbidity;
  Direction sun;                      ///< at the observer
  std::vector<Direction> directions;  ///< where the observer looks
  WavelengthGrid wavelengths = WavelengthGrid::visible();
  std::vector<float> radiance;  ///< [direction][wavelength], W m⁻² sr⁻¹ nm⁻¹; the solver's precision
  std::vector<Yxy> colour;      ///< [direction]: luminance in cd/m², CIE 1931 chromaticity
  std::string instruction_set;  ///< of the kernel that computed it; empty: none

  /// Radiance at every wavelength in one direction, W m⁻² sr⁻¹ nm⁻¹.
  std::span<const float> spectrum(std::size_t direction) const {
    SKYLUT_CHECK_LE((direction + 1) * wavelengths.size(), radiance.size());
    return {radiance.data() + direction * wavelengths.size(), wavelengths.size()};
  }
};

}  // namespace skylut
