#pragma once

#include <vector>

#include "angular_grid.hpp"
#include "shell_geometry.hpp"
#include "skylut/transfer/sky_radiance.hpp"
#include "sweep_stencil.hpp"

namespace skylut::transfer {

/// The numbers behind a quality. Measured errors and times: docs/validation.md, "Convergence".
struct QualityLimits {
  double optical_step;      ///< largest scaled optical depth of a sublayer
  double truncated_peak;    ///< largest share of the scattering that delta-M may cut off as forward peak
  double polar_per_degree;  ///< polar nodes per hemisphere, per Legendre degree
  int least_polar_nodes;
  bool dense_sun_nodes;  ///< every half degree at the terminator
  double ray_step_km;    ///< longest step of a line of sight
  double
      sunbeam_step_km;  ///< largest change of the sunbeam's lowest altitude along a step, near the terminator
  double tolerance;     ///< of the iteration
};
QualityLimits limits_of(Quality quality);

/// What fixes the discretisation of a column. It follows from the column alone, never from the other
/// columns: that is what makes results independent of the batch. Columns with equal keys share the
/// geometry and may share a block of lanes.
struct DiscretisationKey {
  std::vector<int> sublayers;  ///< number of equal parts per layer
  AngularResolution angles;

  bool operator==(const DiscretisationKey&) const = default;
};

/// Chooses the discretisation of a column: layers split until each part's scaled optical depth is below
/// the quality's step, angles fine enough for its phase functions. [docs/validation.md, "Convergence"]
DiscretisationKey discretisation_for(const Shells& shells, const OpticalColumn& column, Quality quality);

/// Lengths of the sunbeam in the layers of the medium, at every point where the sweep needs the beam: the
/// levels and the middles of the sublayers, under every sun node.
class BeamGeometry {
 public:
  BeamGeometry(const ShellGeometry& layers, const ShellGeometry& sublayers,
               const std::vector<double>& sun_nodes_deg);

  /// Points are numbered upwards: 2 k is level k, 2 k + 1 the middle of sublayer k.
  int points() const { return points_; }
  /// Path in each layer, km; null in the planet's shadow.
  const float* path_km(int point, int node) const {
    const auto at = static_cast<std::size_t>(point * nodes_ + node);
    return lit_[at] ? path_km_.data() + at * layers_ : nullptr;
  }

 private:
  int points_;
  int nodes_;
  std::size_t layers_;
  std::vector<char> lit_;
  std::vector<float> path_km_;
};

/// All geometry that the columns with one key share.
struct Discretisation {
  Discretisation(const Shells& shells, const DiscretisationKey& key, Quality quality);

  ShellGeometry layers;     ///< as given: homogeneous
  ShellGeometry sublayers;  ///< split for the sweep
  std::vector<int> layer_of_sublayer;
  AngularGrid angles;
  QualityLimits limits;
  std::vector<double> sun_nodes_deg;
  SweepStencil stencil;
  BeamGeometry beam;
};

}  // namespace skylut::transfer
