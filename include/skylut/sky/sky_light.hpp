#pragma once

#include <span>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/core/wavelength_grid.hpp"

namespace skylut {

/// The diffuse light (no solar disc) that one observer sees under one sun, in any direction: what pictures,
/// irradiances and patches are made of. Calls may run in parallel. Neighbours in a batch that share a zenith
/// angle cost least.
class SkyLight {
 public:
  virtual ~SkyLight() = default;

  virtual const WavelengthGrid& wavelengths() const = 0;
  virtual Direction sun() const = 0;
  /// Zenith angle of the geometric horizon: the observer sees the ground beyond it. 90 on the ground.
  virtual double horizon_zenith_deg() const = 0;

  /// @param directions  where the observer looks, zenith angle [0, 180]
  /// @param radiance    W m⁻² sr⁻¹ nm⁻¹, [direction][wavelength]
  virtual void radiance(std::span<const Direction> directions, std::span<float> radiance) const = 0;

  /// @param colour  CIE 1931 tristimulus values in cd/m², [direction]
  virtual void colour(std::span<const Direction> directions, std::span<Xyz> colour) const = 0;
};

}  // namespace skylut
