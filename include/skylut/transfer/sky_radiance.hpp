#pragma once

#include <span>
#include <string>
#include <vector>

#include "skylut/core/directions.hpp"
#include "skylut/scattering/optical_column.hpp"
#include "skylut/transfer/quality.hpp"

/// The main algorithm of the transfer room: start reading here.
namespace skylut {

struct Context;

/// Where the sky is looked at, under which suns, and in which directions. Every observer sees every
/// sun in every view.
struct SkyRequest {
  std::vector<double> observer_altitudes_km;  ///< above the ground, in [0, top level]
  std::vector<double> sun_zeniths_deg;        ///< at the observer's vertical, in [0, 96]
  std::vector<RelativeView> views;            ///< directions the observer LOOKS
};

struct TransferOptions {
  DiscretisationOptions discretisation = discretisation_of(Quality::standard);
  int scattering_orders = 0;  ///< highest order of scattering; 0: all, until converged
  /// What the work may take before it is refused, bytes; 0: three quarters of the machine's memory.
  double most_memory_bytes = 0.0;
};

/// How a solution was found.
struct TransferReport {
  std::string kernel;       ///< build of the solver: "avx512", "avx2", "portable" or "reference"
  int lanes = 0;            ///< columns that it solves at once
  std::size_t blocks = 0;   ///< of as many columns
  int iterations_most = 0;  ///< of a block
  double error_left = 0.0;  ///< the largest relative error of the mean diffuse radiance, as estimated [I2]
  double cpu_s = 0.0;       ///< of all threads
};

/// Diffuse radiance (the direct sun is not in it) per unit solar irradiance on a plane normal to the
/// beam at the top of the atmosphere, sr⁻¹, for every column, observer, sun and view; >= 0.
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

  TransferReport& report() { return report_; }
  const TransferReport& report() const { return report_; }

 private:
  std::size_t observers_;
  std::size_t suns_;
  std::size_t views_;
  std::vector<float> value_;
  TransferReport report_;
};

/// Radiance of the sky by successive orders of scattering in spherical shells: all orders, Lambertian
/// ground, planet shadow. [theory.md §4]
///
/// A column's result does not depend on the other columns, nor on which observers, suns and views are
/// asked for beside its own, nor on the number of threads: always the same bytes. Between kernels it agrees
/// to rounding (1e-6); the same kernel gives the same bytes on every x86-64 machine.
///
/// Accuracy in haze and clear air at the default quality: 0.7 % [docs/validation.md]; thick layers
/// (optical depth of 10 and more) are several per cent off at draft [theory.md §5].
///
/// @param context  kernel, threads, progress ("solving the radiative transfer") and cancel
/// @param shells   levels and planet radius shared by all columns
/// @param columns  one per wavelength and aerosol load; layer arrays match the shells
/// @throws InputError  for values outside the ranges above (never clamped), and for work that this machine
///                     cannot hold or that would take hours for one block of columns (see transfer_cost.hpp)
/// @throws WorkError   when the orders of scattering do not converge, or memory runs out all the same
/// @throws Cancelled   when the context asks to stop
SkyRadiance solve_sky_radiance(const Context& context, const Shells& shells,
                               std::span<const OpticalColumn> columns, const SkyRequest& request,
                               const TransferOptions& options);

}  // namespace skylut
