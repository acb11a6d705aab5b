#pragma once

#include <memory>

#include "skylut/sky/sky_light.hpp"
#include "skylut/sky/solved_sky.hpp"

namespace skylut {

/// The sky of one observer under one sun by a line of sight for every direction that is asked for: the slow,
/// exact counterpart of ContinuousSky, some 50 µs and more for a direction. Directions of a batch that share
/// a zenith angle share the line.
class ExactSky final : public SkyLight {
 public:
  /// Arguments as ContinuousSky's.
  ExactSky(std::shared_ptr<const SolvedSky> solved, double altitude_km, const Direction& sun,
           double sun_distance_au = 1.0);

  const WavelengthGrid& wavelengths() const override { return solved_->wavelengths(); }
  Direction sun() const override { return sun_; }
  double horizon_zenith_deg() const override { return horizon_zenith_deg_; }
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override;
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override;

 private:
  std::shared_ptr<const SolvedSky> solved_;
  double altitude_km_;
  Direction sun_;
  double horizon_zenith_deg_;
  double scale_;  // by the sun's distance
};

}  // namespace skylut
