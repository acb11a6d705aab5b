#pragma once

#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut {

/// Direction in which light travels through plane layers.
struct PlaneDirection {
  double cos_view = -1.0;  ///< of the zenith angle: > 0 up, < 0 down; [-1, 1] without 0
  /// Azimuth of travel relative to the azimuth of travel of the beam; 0 = the forward half.
  double relative_azimuth_rad = 0.0;
};

/// What is asked of plane-parallel layers lit by the sun. Depths are vertical optical depths measured
/// from the top, in the units of OpticalColumn::extinction_depth.
struct PlaneParallelRequest {
  double cos_sun_zenith = 1.0;  ///< (0, 1]
  /// Uniform light falling on the top, per unit beam irradiance, sr⁻¹, >= 0.
  double isotropic_top_radiance = 0.0;
  std::vector<double> output_depths;  ///< each in [0, total depth]
  std::vector<PlaneDirection> directions;
  /// Discrete ordinates in both hemispheres, even, 4-512; 0: chosen from the phase functions.
  int streams = 0;
  /// Stokes Q and U too, and the radiance of light that is polarised; false: light without polarisation.
  bool polarised = false;

  /// Every view under every azimuth, azimuth fastest, as directions.
  static std::vector<PlaneDirection> every(const std::vector<double>& cos_views,
                                           const std::vector<double>& relative_azimuths_rad);
};

/// Radiances and irradiances per unit beam irradiance on a plane normal to the beam at the top.
struct PlaneParallelResult {
  /// Diffuse radiance, sr⁻¹: [depth][direction] in one array, direction fastest. Without the direct beam.
  std::vector<double> radiance;
  /// Stokes parameters in sr⁻¹, same layout; empty unless polarised. Q = I(E-vector in the vertical plane of
  /// the direction) - I(horizontal); U > 0: E-vector along (downwards for light that rises + towards
  /// increasing azimuth of travel), that is, for who looks at it, along (zenith + increasing azimuth of
  /// view).
  std::vector<double> stokes_q;
  std::vector<double> stokes_u;
  std::vector<double> flux_direct;        ///< per depth, on a horizontal plane, unscattered beam
  std::vector<double> flux_down_diffuse;  ///< per depth
  std::vector<double> flux_up;            ///< per depth
  int streams = 0;                        ///< used
  int azimuth_modes = 0;                  ///< Fourier modes summed until converged
};

/// Plane-parallel radiative transfer with all orders of scattering over a Lambertian ground, by
/// discrete ordinates: eigen-solution of each layer (Nakajima & Tanaka 1986), layers joined by adding,
/// radiances at any angle by integrating the source function, delta-M scaling (Wiscombe 1977) with exact
/// single scattering and the correction of the aureole (TMS and IMS of Nakajima & Tanaka 1988).
/// Conservative layers, pure absorbers, layers of any depth. [plane-parallel-and-monte-carlo.md §1]
///
/// Polarised: the same for (I, Q, U), with phase matrices in place of phase functions (Siewert 2000,
/// doi:10.1016/S0022-4073(99)00006-0, has discrete ordinates for vectors). The ground depolarises; the
/// aureole's second correction (IMS) is I's alone; V is left out.
///
/// Accuracy with automatic streams: see the table in plane-parallel-and-monte-carlo.md §3.
///
/// @param column  layers bottom to top
/// @throws InputError  for values outside the ranges above
/// Directions of many zenith angles are worked through in parts, so that memory is bounded.
/// @throws InputError  for layers or results that the machine cannot hold
/// @throws WorkError   for Legendre moments that no phase function >= 0 has
PlaneParallelResult solve_plane_parallel(const OpticalColumn& column, const PlaneParallelRequest& request);

}  // namespace skylut
