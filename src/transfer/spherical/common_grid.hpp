#pragma once

#include <memory>
#include <vector>

#include "../geometry/ray.hpp"
#include "layer_merge.hpp"
#include "skylut/scattering/optical_column.hpp"
#include "skylut/transfer/quality.hpp"

namespace skylut::transfer {

/// Local solar zenith angles, in degrees, that carry the diffuse field of all suns; density as in
/// DiscretisationOptions.
std::vector<double> sun_nodes(int density);

/// Those of suns beyond 96°, which shine on the highest air alone.
std::vector<double> deep_twilight_nodes(int density);

/// What all columns share under a band of suns: the layers, and the suns among which the field is
/// interpolated.
struct CommonGrid {
  /// @param sun_nodes_deg  local solar zenith angles that carry the diffuse field, at least four
  CommonGrid(const Shells& shells, const DiscretisationOptions& discretisation,
             std::vector<double> sun_nodes_deg);
  /// The same with the nodes of all suns.
  CommonGrid(const Shells& shells, const DiscretisationOptions& discretisation);
  CommonGrid(const CommonGrid&) = delete;
  CommonGrid& operator=(const CommonGrid&) = delete;

  RaySpace ray_space() const {
    return {layers,
            slant_depth,
            sun_interpolation,
            discretisation.ray_step_km,
            discretisation.sunbeam_step_km,
            refractive.get()};
  }

  DiscretisationOptions discretisation;
  Shells shells;                                       ///< the layers, homogeneous
  ShellGeometry layers;                                ///< the same
  std::unique_ptr<const RefractiveShells> refractive;  ///< the same, where they bend light; or none
  LayerMerge merge;                                    ///< the sweep's layers, merged
  SlantDepthGrid slant_depth;
  std::vector<double> sun_nodes_deg;     ///< local solar zenith angles that carry the diffuse field
  CubicInterpolation sun_interpolation;  ///< among them
};

}  // namespace skylut::transfer
