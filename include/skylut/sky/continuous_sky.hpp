#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "skylut/sky/sky_light.hpp"
#include "skylut/sky/solved_sky.hpp"

namespace skylut {

struct Context;
class SkyPatch;

struct ContinuousSkyOptions {
  /// Largest relative error against lines of sight, of any wavelength, that the sky is refined to. [1e-5,
  /// 0.1]
  double tolerance = 1e-3;
  /// How often a patch may be divided or get more azimuths, [0, 6].
  int most_refinements = 4;
};

/// The sky of one observer under one sun as a handful of smooth functions, which answers in any direction for
/// a fraction of a line of sight.
///
/// Each part of SolvedSky::radiance_parts is held as cosine series in azimuth whose coefficients are
/// polynomials in zenith angle, patch by patch (ZenithPanel); the phase functions are multiplied in where a
/// direction is asked for. Every patch is compared with lines of sight between its nodes while it is built,
/// and divided, or given more azimuths, until the tolerance is met. [theory.md §4.9]
///
/// Accuracy against lines of sight: docs/validation.md, "Continuous sky". Cost: some 40 zenith angles × 9
/// azimuths on the ground, 0.14 s of CPU for 81 wavelengths; 100-300 zenith angles and 1 s and more aloft,
/// most in twilight. Then 0.4 µs per colour and 1 µs per spectrum where neighbours in a batch share a zenith
/// angle, 2 and 4.5 µs where they do not (bench/continuous_sky_benchmark, one core).
class ContinuousSky final : public SkyLight {
 public:
  /// @param altitude_km      of the observer, [0, 30]
  /// @param sun              zenith angle [0, 99], close to one that the sky was solved for
  /// @param sun_distance_au  > 0
  /// @throws InputError  for values out of range
  /// @throws Cancelled   when the context asks to stop
  ContinuousSky(const Context& context, std::shared_ptr<const SolvedSky> solved, double altitude_km,
                const Direction& sun, double sun_distance_au = 1.0, const ContinuousSkyOptions& options = {});
  ~ContinuousSky() override;

  const WavelengthGrid& wavelengths() const override { return solved_->wavelengths(); }
  Direction sun() const override { return sun_; }
  double horizon_zenith_deg() const override { return horizon_zenith_deg_; }
  void radiance(std::span<const Direction> directions, std::span<float> radiance) const override;
  void colour(std::span<const Direction> directions, std::span<Xyz> colour) const override;

  /// The largest relative error found where the patches were compared with lines of sight: of luminance, or a
  /// third of a wavelength's.
  double error() const { return error_; }
  /// Zenith angles and azimuths that were computed, all patches together.
  std::size_t nodes() const;

 private:
  std::size_t patch_of(double zenith_deg) const;
  /// Calls use(index, row, direction) for every direction; neighbours of one zenith angle share a row.
  template <class Row, class Use>
  void look(std::span<const Direction> directions, const Row& row_of, const Use& use) const;

  std::shared_ptr<const SolvedSky> solved_;
  Direction sun_;
  double apparent_sun_deg_;  ///< zenith angle
  double horizon_zenith_deg_;
  double scale_;                   // by the sun's distance
  std::vector<SkyPatch> patches_;  // by ascending zenith angle
  double error_ = 0.0;
};

}  // namespace skylut
