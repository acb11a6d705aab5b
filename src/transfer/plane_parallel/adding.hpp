#pragma once

#include <Eigen/Core>
#include <vector>

#include "layer_modes.hpp"

namespace skylut::plane_parallel {

/// Light that enters the column from outside in one Fourier mode, and its ground.
struct Illumination {
  double cos_sun = 1.0;
  double isotropic_top = 0.0;  ///< sr⁻¹; nothing for m > 0
  double ground_albedo = 0.0;  ///< Lambertian; nothing for m > 0
};

/// Diffuse radiances at every boundary, scaled ι = (wμ)^½ I, one vector per boundary from the top.
struct BoundaryFields {
  std::vector<Eigen::VectorXd> down;
  std::vector<Eigen::VectorXd> up;
};

/// Joins the slices by adding (van de Hulst 1980, ch. 4; Grant & Hunt 1969): up from the ground, the
/// reflection of everything below each boundary; then down from the top, the light itself.
/// @param modes  one per material of the medium
BoundaryFields join_slices(const ScaledMedium& medium, const std::vector<LayerModes>& modes,
                           const Ordinates& ordinates, const Illumination& light);

}  // namespace skylut::plane_parallel
