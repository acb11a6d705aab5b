#pragma once

#include <vector>

#include "interpolation.hpp"
#include "layer_merge.hpp"
#include "shell_geometry.hpp"
#include "skylut/scattering/optical_column.hpp"
#include "skylut/transfer/quality.hpp"
#include "sun_depth_grid.hpp"

namespace skylut::transfer {

/// What all columns of a request share.
struct Medium {
  Medium(const Shells& shells, const QualityLimits& limits);
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
