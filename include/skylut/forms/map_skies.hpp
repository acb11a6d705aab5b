#pragma once

#include <filesystem>
#include <vector>

#include "skylut/forms/sky_supply.hpp"

namespace skylut {

/// Skies from files: a sky.csv as `skylut map` and `skylut table --save-maps` write it, or a folder of such.
/// Each says in its comments under which conditions it was seen (altitude_km, turbidity, turbidity_kind,
/// sun_zenith_deg, sun_azimuth_deg).
class MapSkies final : public SkySupply {
 public:
  /// Files of a folder are taken in the order of their names. Skies under suns of one zenith angle that
  /// differ in azimuth alone are mirror images: the first stands for all.
  /// @throws InputError  "file:line: what is wrong, what would be right"; a folder without .csv files; maps
  /// of
  ///                     different turbidity kinds or wavelengths
  explicit MapSkies(const std::filesystem::path& file_or_folder);

  const SkyAxes& axes() const override { return axes_; }
  const WavelengthGrid* wavelengths() const override { return wavelengths_ ? &*wavelengths_ : nullptr; }
  bool simulates() const override { return false; }
  std::optional<double> albedo() const override { return std::nullopt; }
  /// The files' skies in the files' directions up to 90°, whatever the views; by solid angle as far as their
  /// rings tell.
  std::vector<TrainingSky> given(const Context& context, const ViewsUnderSun& views) const override;
  /// @throws InputError  always
  std::vector<TrainingSky> simulated(const Context& context, std::span<const SoughtSky> requests,
                                     const ViewsUnderSun& views) const override;

  /// That were read.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::filesystem::path input_;
  std::vector<std::filesystem::path> files_;
  SkyAxes axes_;
  std::optional<WavelengthGrid> wavelengths_;
  std::vector<TrainingSky> skies_;
};

}  // namespace skylut
