#pragma once

#include <memory>

#include "skylut/models/sky_model.hpp"
#include "skylut/sky/sky_light.hpp"

namespace skylut {

/// The sky of a model as light to draw pictures of. Directions that the model has nothing for are black.
class ModelLight final : public SkyLight {
 public:
  /// @param view_zenith_deg  that the model answers for: ModelInfo::view_zenith_deg
  /// @param altitude_km      of the observer, for the geometric horizon
  ModelLight(std::shared_ptr<const Sky> sky, const Range& view_zenith_deg, const Direction& sun,
             double altitude_km);

  /// Of a model that knows colours only: one wavelength, of which there is no radiance.
  const WavelengthGrid& wavelengths() const override { return wavelengths_; }
  Direction sun() const override { return sun_; }
  /// The geometric horizon of a sphere of 6371 km; or where the model's sky ends, if that is above it.
  double horizon_zenith_deg() const override { return horizon_zenith_deg_; }

  /// @throws InputError  of a model that knows colours only
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override;
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override;

 private:
  std::shared_ptr<const Sky> sky_;
  Range view_zenith_deg_;
  Direction sun_;
  double horizon_zenith_deg_ = 90.0;
  WavelengthGrid wavelengths_;
};

}  // namespace skylut
