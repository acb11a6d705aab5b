#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut::plane_parallel {

/// What a layer's material does, after delta-M scaling (Wiscombe 1977): a fraction f = χ_n of the
/// scattering, in the forward peak that n streams cannot resolve, counts as not scattered.
struct LayerOptics {
  double scattering_albedo = 0.0;  ///< ω' = ω (1-f) / (1-fω)
  double forward_fraction = 0.0;   ///< f
  double depth_factor = 1.0;       ///< dτ'/dτ = 1 - fω
  Eigen::VectorXd moments;         ///< χ'_l = (χ_l - f) / (1-f), l < streams
  /// Moments of the scattering matrix, scaled: α2, α3 as χ from l = 2 on, β1' = β1 / (1-f), since the peak
  /// keeps the polarisation and makes none. Empty where it is not asked for.
  Eigen::VectorXd alpha2;
  Eigen::VectorXd alpha3;
  Eigen::VectorXd beta1;
  std::vector<double> scatterer_albedos;  ///< unscaled share of each scatterer in the extinction, Σ = ω

  bool operator==(const LayerOptics&) const = default;
};

/// A homogeneous slice; slices end at every layer boundary and every output depth.
struct Slice {
  std::size_t optics = 0;  ///< index into ScaledMedium::optics
  double depth = 0.0;      ///< unscaled
  double scaled_depth = 0.0;
};

/// The column from the top down, scaled.
struct ScaledMedium {
  int streams = 0;
  std::vector<LayerOptics> optics;         ///< distinct materials
  std::vector<Slice> slices;               ///< top to bottom; boundary b lies above slice b
  std::vector<std::size_t> output_bounds;  ///< boundary of each output depth
  std::vector<double> boundary_depth;      ///< unscaled, from the top, slices.size() + 1
  std::vector<double> boundary_scaled;     ///< scaled
};

/// Streams that resolve the column's phase functions: the least even n with all moments from χ_n on
/// below 1e-4, not less than 48 (grazing angles in thin layers) nor more than `most`.
int streams_for(const OpticalColumn& column, int most);

/// @param polarised  with the moments of the scattering matrices
/// @throws InputError  if an output depth lies outside the column
ScaledMedium scale_medium(const OpticalColumn& column, const std::vector<double>& output_depths, int streams,
                          bool polarised);

}  // namespace skylut::plane_parallel
