#pragma once

#include <functional>
#include <span>
#include <vector>

#include "skylut/core/directions.hpp"
#include "skylut/scattering/optical_column.hpp"
#include "skylut/transfer/quality.hpp"

/// The main algorithm of the transfer room: start reading here.
namespace skylut {

/// Where the sky is looked at, under which suns, and in which directions. Every observer sees every
/// sun in every view.
struct SkyRequest {
  std::vector<double> observer_altitudes_km;  ///< above the ground, in [0, top level]
  std::vector<double> sun_zeniths_deg;        ///< at the observer's vertical, in [0, 96]
  std::vector<RelativeView> views;            ///< directions the observer LOOKS
};

struct TransferOptions {
  QualityLimits limits = limits_of(Quality::standard);
  int threads = 0;  ///< 0: all cores. Results do not depend on it.
  int orders = 0;   ///< highest order of scattering; 0: all, until converged
  /// Called with (blocks done, blocks in all) from any thread, one call at a time; may be empty.
  std::function<void(std::size_t, std::size_t)> progress;
};

/// Diffuse radiance (the direct sun is not in it) per unit solar irradiance on a plane normal to the
/// beam at the top of the atmosphere, sr⁻¹, for every column, observer, sun and view.
class SkyRadiance {
 public:
  SkyRadiance(std::size_t columns, std::size_t observers, std::size_t suns, std::size_t views)
      : observers_(observers), suns_(suns), views_(views), value_(columns * observers * suns * views) {}

  float& at(std::size_t column, std::size_t observer, std::size_t sun, std::size_t view) {
    return value_[((column * observers_ + observer) * suns_ + sun) * views_ + view];
  }
  float at(std::size_t column, std::size_t observer, std::size_t sun, std::size_t view) const {
    return value_[((column * observers_ + observer) * suns_ + sun) * views_ + view];
  }

 private:
  std::size_t observers_;
  std::size_t suns_;
  std::size_t views_;
  std::vector<float> value_;
};

/// Radiance of the sky by successive orders of scattering in spherical shells: all orders, Lambertian
/// ground, planet shadow. [theory.md §4]
///
/// A column's result does not depend on the other columns, nor on which observers, suns and views are
/// asked for beside its own, nor on the number of threads: always the same bytes.
///
/// @param shells   levels and planet radius shared by all columns
/// @param columns  one per wavelength and aerosol load; layer arrays match the shells
/// @throws InputError  for values outside the ranges above (never clamped)
/// @throws WorkError   when the orders of scattering do not converge
SkyRadiance solve_sky_radiance(const Shells& shells, std::span<const OpticalColumn> columns,
                               const SkyRequest& request, const TransferOptions& options);

}  // namespace skylut
