#pragma once

#include <span>
#include <vector>

#include "discretisation.hpp"

namespace skylut::transfer {

/// Optical properties of the columns of one block, laid out for the kernel: the innermost index is the
/// lane. Delta-M scaled (Wiscombe 1977) at the angular grid's highest degree, except `scattering`.
/// [theory.md §4.4, eqs. S1-S4]
struct BlockOptics {
  /// Packs columns (at most `lanes`; the last one fills the lanes left over).
  BlockOptics(const Discretisation& grid, std::span<const OpticalColumn* const> columns, int lanes);

  int lanes;
  std::vector<const OpticalColumn*> column;  ///< one per lane
  int scatterers;                            ///< the most that a lane has

  std::vector<float> extinction_per_km;  ///< [layer][lane], scaled
  std::vector<float> source_factor;      ///< [layer][degree l][lane]: ω (2l+1) χ_l, scaled
  std::vector<float> scattering_per_km;  ///< [scatterer][layer][lane], not scaled: exact single scattering
  std::vector<float> ground_albedo;      ///< [lane]

  /// Exact phase function of each scatterer and lane at one scattering angle: [scatterer][lane].
  void phase_values(double cos_scattering_angle, float* value) const;
};

}  // namespace skylut::transfer
