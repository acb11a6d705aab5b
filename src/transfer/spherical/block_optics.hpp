#pragma once

#include <span>
#include <vector>

#include "discretisation.hpp"
#include "kernel_problem.hpp"

namespace skylut::transfer {

/// Optical properties of the columns of one block, laid out for the kernel: the innermost index is the
/// lane. Delta-M scaled (Wiscombe 1977) at the angular grid's highest degree, except `scattering`.
/// [theory.md §4.2, S1-S4]
struct BlockOptics {
  /// Packs columns (at most `lanes`; the last one fills the lanes left over).
  /// @param delta_m  false: leave the forward peak in, so that orders of scattering are those of the medium
  BlockOptics(const Discretisation& grid, std::span<const OpticalColumn* const> columns, int lanes,
              bool delta_m);

  int lanes;
  std::vector<const OpticalColumn*> column;  ///< one per lane
  int scatterers;                            ///< the most that a lane has

  std::vector<float> extinction_per_km;  ///< [layer][lane], scaled
  std::vector<float> source_factor;      ///< [layer][degree l][lane]: ω (2l+1) χ_l, scaled
  std::vector<float> scattering_per_km;  ///< [scatterer][layer][lane], not scaled: exact single scattering
  std::vector<float> ground_albedo;      ///< [lane]

  OpticsView view() const {
    return {scatterers, extinction_per_km.data(), source_factor.data(), scattering_per_km.data(),
            ground_albedo.data()};
  }

  /// Exact phase function of each scatterer and lane at one scattering angle: [scatterer][lane].
  void phase_values(double cos_scattering_angle, float* value) const;
};

}  // namespace skylut::transfer
