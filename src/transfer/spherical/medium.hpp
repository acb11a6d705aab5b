#pragma once

#include <vector>

#include "interpolation.hpp"
#include "layer_merge.hpp"
#include "shell_geometry.hpp"
#include "skylut/transfer/sky_radiance.hpp"
#include "sun_depth_grid.hpp"

namespace skylut::transfer {

/// The numbers behind a quality. Measured errors and times: docs/validation.md, "Convergence".
struct QualityLimits {
  double optical_step;      ///< largest scaled optical depth of a sublayer
  double truncated_peak;    ///< largest share of the scattering that delta-M may cut off as forward peak
  double polar_per_degree;  ///< polar nodes per hemisphere, per Legendre degree
  int least_polar_nodes;
  bool dense_sun_nodes;  ///< every half degree at the terminator
  bool merge_layers;     ///< thin layers are taken together in the sweep
  int field_stride;      ///< a line of sight asks the field at every so many sublayers within a layer
  double ray_step_km;    ///< longest step of a line of sight
  double
      sunbeam_step_km;  ///< largest change of the sunbeam's lowest altitude along a step, near the terminator
  double tolerance;     ///< of the iteration
};
QualityLimits limits_of(Quality quality);

/// What all columns of a request share.
struct Medium {
  Medium(const Shells& shells, Quality quality);
  Medium(const Medium&) = delete;
  Medium& operator=(const Medium&) = delete;

  QualityLimits limits;
  Shells shells;         ///< the layers, homogeneous
  ShellGeometry layers;  ///< the same
  LayerMerge merge;      ///< the sweep's layers, merged
  SunDepthGrid sun_depth;
  std::vector<double> sun_nodes_deg;     ///< local solar zenith angles that carry the diffuse field
  CubicInterpolation sun_interpolation;  ///< among them
};

}  // namespace skylut::transfer
