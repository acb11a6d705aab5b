#pragma once

#include <utility>
#include <vector>

#include "skylut/models/channel_sky.hpp"
#include "skylut/models/perez.hpp"

namespace skylut {

/// One Perez formula, scaled: scale · F(θ, γ).
struct ScaledPerez {
  PerezCoefficients coefficients;
  double scale = 1.0;
};

/// v_z F(θ, γ)/F(0, θ_s) as a scaled formula.
inline ScaledPerez scaled_to_zenith(const PerezCoefficients& coefficients, double zenith_value,
                                    double sun_zenith_rad) {
  return {coefficients, zenith_value / perez(coefficients, 0.0, sun_zenith_rad)};
}

/// A sky of one Perez formula per channel. Its sun may differ from the one that the formulas were scaled for:
/// γ is counted from the sky's own, so that the aureole is where the sun is.
class PerezChannelSky final : public ChannelSky {
 public:
  PerezChannelSky(std::shared_ptr<const ModelFrame> frame, const Direction& sun,
                  std::vector<ScaledPerez> formulas)
      : ChannelSky(std::move(frame), sun), formulas_(std::move(formulas)) {}

  void values(const Direction& view, std::span<double> values) const override;

 private:
  std::vector<ScaledPerez> formulas_;
};

}  // namespace skylut
