#pragma once

#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut {

/// What is asked of plane-parallel layers lit by the sun. Depths are vertical optical depths measured
/// from the top, in the units of OpticalColumn::extinction_depth.
struct PlaneParallelRequest {
  double cos_sun_zenith = 1.0;  ///< (0, 1]
  double isotropic_top_radiance =
      0.0;  ///< uniform light falling on the top, per unit beam irradiance, sr⁻¹, >= 0
  std::vector<double> output_depths;  ///< each in [0, total depth]
  /// Cosines of the direction in which the light travels: > 0 up, < 0 down; [-1, 1] without 0.
  std::vector<double> cos_views;
  /// Azimuth of travel relative to the azimuth of travel of the beam; 0 = the forward half.
  std::vector<double> relative_azimuths_rad;
  int streams =
      0;  ///< discrete ordinates in both hemispheres, even, 4-512; 0: chosen from the phase functions
};

/// Radiances and irradiances per unit beam irradiance on a plane normal to the beam at the top.
struct PlaneParallelResult {
  /// Diffuse radiance, sr⁻¹: [depth][view][azimuth] in one array, azimuth fastest. Without the direct beam.
  std::vector<double> radiance;
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
/// Accuracy with automatic streams: see the table in plane-parallel-and-monte-carlo.md §3.
///
/// @param column  layers bottom to top
/// @throws InputError  for values outside the ranges above
/// @throws WorkError   for Legendre moments that no phase function >= 0 has
PlaneParallelResult solve_plane_parallel(const OpticalColumn& column, const PlaneParallelRequest& request);

}  // namespace skylut
