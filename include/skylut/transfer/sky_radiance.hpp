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

/// One thing to see: where from, under which sun, in which direction.
struct Sight {
  double observer_altitude_km = 0.0;  ///< above the ground, in [0, 1e6]; above the top level: from outside
  double sun_zenith_deg = 0.0;        ///< at the observer's vertical, in [0, 99]; from outside [0, 180]
  RelativeView view;                  ///< direction the observer LOOKS
};

/// Many sights by their product: every observer sees every sun in every view.
struct SkyRequest {
  std::vector<double> observer_altitudes_km;
  std::vector<double> sun_zeniths_deg;
  std::vector<RelativeView> views;

  /// The views vary fastest, the observers slowest.
  std::vector<Sight> sights() const;
};

struct TransferOptions {
  DiscretisationOptions discretisation = discretisation_of(Quality::standard);
  int scattering_orders = 0;  ///< highest order of scattering; 0: all, until converged
  /// Whether Q and U of the sky are wanted beside I. Needs a discretisation that follows polarisation.
  bool stokes = false;
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
/// beam at the top of the atmosphere, sr⁻¹, for every column and sight; I >= 0. Stokes parameters where they
/// were asked for: Q = I in the vertical plane of the line of sight - I across it (of the electric vector),
/// U > 0 where it lies towards zenith and growing azimuth. [docs/polarisation.md P1]
class SkyRadiance {
 public:
  SkyRadiance(std::size_t columns, std::size_t sights, bool stokes = false)
      : sights_(sights), value_(columns * sights), polarised_(stokes ? 2 * columns * sights : 0) {}

  bool has_stokes() const { return !polarised_.empty(); }
  float& stokes_q(std::size_t column, std::size_t sight) { return polarised_[column * sights_ + sight]; }
  float stokes_q(std::size_t column, std::size_t sight) const { return polarised_[column * sights_ + sight]; }
  float& stokes_u(std::size_t column, std::size_t sight) {
    return polarised_[value_.size() + column * sights_ + sight];
  }
  float stokes_u(std::size_t column, std::size_t sight) const {
    return polarised_[value_.size() + column * sights_ + sight];
  }

  float& at(std::size_t column, std::size_t sight) { return value_[column * sights_ + sight]; }
  float at(std::size_t column, std::size_t sight) const { return value_[column * sights_ + sight]; }

  /// Of a SkyRequest.
  float at(std::size_t column, std::size_t observer, std::size_t sun, std::size_t view) const {
    return at(column, (observer * suns_ + sun) * views_ + view);
  }
  void set_shape(std::size_t suns, std::size_t views) {
    suns_ = suns;
    views_ = views;
  }

  TransferReport& report() { return report_; }
  const TransferReport& report() const { return report_; }

 private:
  std::size_t sights_;
  std::size_t suns_ = 0;
  std::size_t views_ = 0;
  std::vector<float> value_;
  std::vector<float> polarised_;  // Q of all, then U; empty: not asked for
  TransferReport report_;
};

/// Radiance of the sky by successive orders of scattering in spherical shells: all orders, Lambertian
/// ground, planet shadow. [theory.md §4]
///
/// A column's result does not depend on the other columns, nor on which sights are asked for beside its own,
/// nor on the number of threads: always the same bytes. Between kernels it agrees to rounding (1e-6); the
/// same kernel gives the same bytes on every x86-64 machine.
///
/// Accuracy at the default quality: 0.7 % in haze, clear air and clouds of optical depth to 64
/// [docs/validation.md, theory.md §5].
///
/// @param context  kernel, threads, progress ("solving the radiative transfer") and cancel
/// @param shells   levels and planet radius shared by all columns
/// @param columns  one per wavelength and aerosol load; layer arrays match the shells
/// @throws InputError  for values outside the ranges above (never clamped), and for work that this machine
///                     cannot hold or that would take hours for one block of columns (see transfer_cost.hpp)
/// @throws WorkError   when the orders of scattering do not converge, or memory runs out all the same
/// @throws Cancelled   when the context asks to stop
SkyRadiance solve_sky_radiance(const Context& context, const Shells& shells,
                               std::span<const OpticalColumn> columns, std::span<const Sight> sights,
                               const TransferOptions& options);

/// The same for all sights of a request.
SkyRadiance solve_sky_radiance(const Context& context, const Shells& shells,
                               std::span<const OpticalColumn> columns, const SkyRequest& request,
                               const TransferOptions& options);

}  // namespace skylut
