#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "skylut/models/sky_channels.hpp"
#include "skylut/models/sky_model.hpp"

namespace skylut {

/// What all skies of a fitted model share.
struct ModelFrame {
  ModelInfo info;
  SkyChannels channels;
};

/// A sky of one formula per channel, and its colours and spectra as they follow.
class ChannelSky : public Sky {
 public:
  /// @param frame  never null
  ChannelSky(std::shared_ptr<const ModelFrame> frame, const Direction& sun)
      : frame_(std::move(frame)), sun_(sun) {}

  using Sky::colour;
  void colour(std::span<const Direction> views, std::span<Yxy> colours) const override;
  const WavelengthGrid* wavelengths() const override;
  void radiance(std::span<const Direction> views, std::span<float> radiance) const override;

  const Direction& sun() const { return sun_; }
  const SkyChannels& channels() const { return frame_->channels; }

  /// @param view    within the model's domain
  /// @param values  [channel], filled
  virtual void values(const Direction& view, std::span<double> values) const = 0;

 private:
  std::shared_ptr<const ModelFrame> frame_;
  Direction sun_;
};

/// Several skies under one sun, blended: the logarithms of light, chromaticities as they are.
class BlendedSky final : public ChannelSky {
 public:
  struct Part {
    double weight = 1.0;  ///< those of all parts sum to 1
    std::unique_ptr<const ChannelSky> sky;
  };

  BlendedSky(std::shared_ptr<const ModelFrame> frame, const Direction& sun, std::vector<Part> parts)
      : ChannelSky(std::move(frame), sun), parts_(std::move(parts)) {}

  void values(const Direction& view, std::span<double> values) const override;

 private:
  std::vector<Part> parts_;
};

}  // namespace skylut
