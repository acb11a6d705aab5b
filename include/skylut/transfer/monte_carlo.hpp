#pragma once

#include <cstdint>
#include <vector>

#include "skylut/core/directions.hpp"
#include "skylut/scattering/optical_column.hpp"

namespace skylut {

struct Context;

/// One observer under one sun in spherical shells.
struct MonteCarloRequest {
  double observer_altitude_km = 0.0;  ///< [0, top level]
  double sun_zenith_deg = 0.0;        ///< at the observer's vertical, [0, 180]
  std::vector<RelativeView> views;    ///< directions the observer LOOKS
};

struct MonteCarloOptions {
  std::uint64_t photons = 100'000;  ///< per view, 128 to 1e12; rounded up to a multiple of 64 (the batches)
  std::uint64_t seed = 1;
  int orders = 0;  ///< highest number of scatterings and ground reflections; 0: all
  /// Light with Stokes parameters I, Q, U by the scatterers' matrices, instead of a number by their phase
  /// functions.
  bool polarised = false;
};

/// Mean and one standard error of it, from 64 independent batches; per unit solar irradiance on a plane
/// normal to the beam at the top of the atmosphere, sr⁻¹, without the direct sun.
struct MonteCarloRadiance {
  double radiance = 0.0;
  double standard_error = 0.0;
  /// Q = I (E-vector in the vertical plane of the line of sight) - I (horizontal); U > 0: E-vector along
  /// (towards the zenith + towards increasing relative azimuth)/√2. 0 where polarised is false. V is left out
  /// (scattering/scattering_matrix.hpp).
  double stokes_q = 0.0;
  double stokes_q_error = 0.0;  ///< one standard error
  double stokes_u = 0.0;
  double stokes_u_error = 0.0;  ///< one standard error
  std::uint64_t photons = 0;    ///< traced
};

/// Radiance of the sky by backward Monte Carlo in spherical shells (Collins et al. 1972): photons leave the
/// observer against the light; each scattering and ground reflection adds the probability that the light
/// came straight from the sun. All orders, exact phase functions, exact straight paths, planet shadow,
/// Lambertian ground; unbiased. Shares nothing with solve_sky_radiance but its data types, so each can
/// judge the other. [plane-parallel-and-monte-carlo.md §2]
///
/// The result is a function of (photons, seed) and the view alone: not of threads or other views.
/// Very peaked phase functions (forward value above some 1000) give rare large contributions: the error is
/// then honest but falls slowly.
///
/// @return one estimate per view
/// @param context  threads, progress ("tracing photons") and cancel
/// @throws InputError  for values outside the ranges above
/// @throws Cancelled   when the context asks to stop
std::vector<MonteCarloRadiance> solve_monte_carlo(const Context& context, const Shells& shells,
                                                  const OpticalColumn& column,
                                                  const MonteCarloRequest& request,
                                                  const MonteCarloOptions& options);

}  // namespace skylut
