#pragma once

#include <functional>
#include <memory>

#include "skylut/forms/sky_supply.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "skylut/transfer/sky_radiance.hpp"

namespace skylut {

/// Skies simulated through the atmosphere of a scene: what a table folder stands for. All suns of one load
/// are solved together, and each sky is a ContinuousSky, so that views cost little.
class SimulatedSkies final : public SkySupply {
 public:
  /// The scene's air over a ground of that albedo, [0, 1].
  using AirOverGround = std::function<std::shared_ptr<const Atmosphere>(double albedo)>;

  /// @param scene  its altitudes, turbidities and suns are the axes; its directions are not used
  SimulatedSkies(SkyScene scene, TransferOptions options, AirOverGround air_over_ground);

  const SkyAxes& axes() const override { return axes_; }
  const WavelengthGrid* wavelengths() const override { return &scene_.wavelengths; }
  bool simulates() const override { return true; }
  std::optional<Air> air() const override { return Air{scene_, options_}; }
  std::optional<double> albedo() const override;
  std::vector<TrainingSky> given(const Context& context, const ViewsUnderSun& views) const override;
  std::vector<TrainingSky> simulated(const Context& context, std::span<const SoughtSky> requests,
                                     const ViewsUnderSun& views) const override;

 private:
  SkyScene scene_;
  TransferOptions options_;
  AirOverGround air_over_ground_;
  SkyAxes axes_;
};

}  // namespace skylut
