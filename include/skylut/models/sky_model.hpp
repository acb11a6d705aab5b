#pragma once

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"

namespace skylut {

/// A sky: luminance and chromaticity for any view. Published models, simulations and fitted tables share
/// this interface so that any two of them can be compared.
class SkyModel {
 public:
  virtual ~SkyModel() = default;

  /// @param sun   of any azimuth; models state which zenith angles they take
  /// @param view  zenith angle within 0-90°
  /// @return      Y in cd/m², without the solar disc
  /// @throws InputError  outside the model's range, never clamped
  virtual Yxy sky(const Direction& sun, const Direction& view) const = 0;

 protected:
  SkyModel() = default;
  SkyModel(const SkyModel&) = default;
  SkyModel& operator=(const SkyModel&) = default;
};

}  // namespace skylut
