#pragma once

#include <memory>
#include <span>
#include <vector>

#include "skylut/sky/exact_sky.hpp"

namespace skylut {

struct Context;
class SkyPatch;

/// The sky of one observer from the zenith to 90° as one smooth function, from 14 to 16 lines of sight in 9
/// azimuths (13 in twilight, 1 with the sun at the zenith): what a table of many skies is seen with. Beyond
/// 90° it answers by lines of sight.
///
/// The parts of SolvedSky::radiance_parts are cosine series in azimuth whose coefficients are one polynomial
/// in ln(1 + e/1.5°) of the elevation e; the phase functions are multiplied in where a direction is asked
/// for. Unlike ContinuousSky it does not look whether that is fine enough. [theory.md K6]
///
/// Accuracy against lines of sight, luminance: 0.04 % by solid angle and 1 % in the worst direction with the
/// sun up; in twilight, where the Earth's shadow has an edge, 0.5 % and 6 % to 94°, 2 % and 26 % at 96°.
/// Cost: a quarter to a sixth of a dome's lines of sight for one sun, less for each of many.
class DomeSky final : public SkyLight {
 public:
  /// Skies of one observer, [sun], which share what belongs to their lines of sight alone.
  /// @param altitude_km      of the observer, [0, 30]
  /// @param sun_zeniths_deg  [0, 99], close to those that the sky was solved for; their azimuths are 0
  /// @param sun_distance_au  > 0
  /// @throws InputError  for values out of range
  /// @throws Cancelled   when the context asks to stop
  static std::vector<DomeSky> under_suns(const Context& context,
                                         const std::shared_ptr<const SolvedSky>& solved, double altitude_km,
                                         std::span<const double> sun_zeniths_deg,
                                         double sun_distance_au = 1.0);
  ~DomeSky() override;
  DomeSky(DomeSky&&) noexcept;

  const WavelengthGrid& wavelengths() const override { return solved_->wavelengths(); }
  Direction sun() const override { return exact_.sun(); }
  double horizon_zenith_deg() const override { return exact_.horizon_zenith_deg(); }
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override;
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override;

  /// The same sky by lines of sight everywhere.
  const ExactSky& exact() const { return exact_; }

  /// Mean luminance by solid angle between 90° and the geometric horizon, cd/m²; 0 on the ground.
  double luminance_below() const;

 private:
  DomeSky(std::shared_ptr<const SolvedSky> solved, double altitude_km, double sun_zenith_deg,
          double sun_distance_au);
  static void follow_lines(const Context& context, std::span<DomeSky* const> skies, double altitude_km,
                           std::unique_ptr<SkyPatch> DomeSky::*patch);

  std::shared_ptr<const SolvedSky> solved_;
  ExactSky exact_;
  double scale_;        // by the sun's distance
  Direction seen_sun_;  // apparent
  std::unique_ptr<SkyPatch> dome_;
  std::unique_ptr<SkyPatch> limb_;  // too coarse to be looked at but in the mean; none on the ground
};

}  // namespace skylut
