#pragma once

#include <span>
#include <vector>

#include "../geometry/ray.hpp"
#include "discretisation.hpp"
#include "forward_peak_correction.hpp"
#include "horizon_peak.hpp"
#include "kernel_problem.hpp"

namespace skylut::transfer {

/// Delta-M scaled properties (Wiscombe 1977) of homogeneous layers; the innermost index is the lane.
/// [theory.md §4.2, eqs. S1-S4]
struct ScaledLayers {
  std::vector<float> extinction_per_km;  ///< [layer][lane]
  std::vector<float> source_factor;      ///< [layer][degree l][lane]: ω (2l+1) χ_l
  std::vector<float>
      polarised_factor;  ///< [layer][degree l][beta1, alpha2, alpha3][lane]: ω (2l+1) times them

  LayerView view() const { return {extinction_per_km.data(), source_factor.data(), polarised_factor.data()}; }
};

/// Optical properties of the columns of one block, laid out for the kernel.
struct BlockOptics {
  /// Packs columns (at most `lanes`; the last one fills the lanes left over).
  /// @param delta_m  false: leave the forward peak in, so that orders of scattering are those of the medium
  BlockOptics(const Discretisation& grid, std::span<const OpticalColumn* const> columns, int lanes,
              bool delta_m);

  int lanes;
  std::vector<const OpticalColumn*> column;  ///< one per lane
  int scatterers;                            ///< the most that a lane has

  ScaledLayers layers;                   ///< of the medium, for lines of sight and the sunbeam
  ScaledLayers sweep_layers;             ///< merged, for the sweep
  std::vector<float> scattering_per_km;  ///< [scatterer][layer][lane], not scaled: exact single scattering
  std::vector<float> peak_per_km;        ///< [layer][lane]: scattering that delta-M takes for none
  HorizonPeaks horizon;                  ///< those that are corrected at the horizon
  std::vector<float> ground_albedo;      ///< [lane]

  OpticsView view() const {
    return {.scatterers = scatterers,
            .layers = layers.view(),
            .sweep_layers = sweep_layers.view(),
            .scattering_per_km = scattering_per_km.data(),
            .peak_per_km = peak_per_km.data(),
            .horizon_peaks = horizon.peaks,
            .horizon_moment = horizon.moment.data(),
            .horizon_share = horizon.share.data(),
            .ground_albedo = ground_albedo.data()};
  }

  /// Exact phase functions at the scattering angles of a ray's pairs: [pair][scatterer][lane].
  std::vector<float> phases(const Ray& ray) const;
  /// The same of F12, which polarises.
  std::vector<float> polarising_phases(const Ray& ray) const;
  /// What spreads the phase functions' peaks, for the pairs close to the sun: [aureole][first,
  /// second][scatterer][lane].
  std::vector<float> peaks(const Ray& ray) const;
  /// What the parts of a lane's radiance are multiplied by: P of each scatterer, -Q1 of each, Q2 of each, 1.
  /// @param factor  for as many scatterers as there is room, at least the lane's own; those left over get 0
  void part_factors(int lane, double cos_scattering_angle, std::span<double> factor) const;

 private:
  /// Of each scatterer and lane at one scattering angle: [scatterer][lane], [first, second][scatterer][lane].
  void phase_values(double cos_scattering_angle, float* value) const;
  void peak_values(double cos_scattering_angle, float* value) const;

  std::vector<std::vector<ForwardPeakCorrection>> spread_;  // [lane][the lane's own scatterers]
};

}  // namespace skylut::transfer
