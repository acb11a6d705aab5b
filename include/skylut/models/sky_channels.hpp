#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/core/wavelength_grid.hpp"

namespace skylut {

/// What the values of a fitted model's formulas are, one formula per channel.
struct SkyChannels {
  enum class Kind {
    Yxy,   ///< luminance in cd/m² and chromaticity: 3
    Xyz,   ///< tristimulus values in cd/m²: 3
    bands  ///< radiance, W m⁻² sr⁻¹ nm⁻¹: one per wavelength
  };

  Kind kind = Kind::Yxy;
  /// Of bands; each is the mean over its step.
  std::optional<WavelengthGrid> wavelengths = {};
  /// Of bands: tristimulus values of a unit of radiance in each.
  std::vector<Xyz> colour_weights = {};

  std::size_t size() const { return wavelengths ? wavelengths->size() : 3; }
  /// Whether a value is a share of light, which can be blended by its logarithm, and is fitted relatively.
  bool is_light(std::size_t channel) const { return kind != Kind::Yxy || channel == 0; }

  /// The colour of one direction. @param values  [size()]
  Yxy colour(std::span<const double> values) const;
  /// The inverse where no colour was measured: values of the channels, [size()]. Not of bands.
  std::vector<double> values(const Yxy& colour) const;

  std::string quantities() const;  ///< for people: "Y, x, y", "X, Y, Z", "radiance in 11 bands, 380-780 nm"
  std::vector<std::string> names() const;

  nlohmann::ordered_json json() const;
  /// @throws InputError  naming file and key
  static SkyChannels read(const JsonReader& json);
};

}  // namespace skylut
