#pragma once

#include <vector>

#include "angular_grid.hpp"
#include "layer_merge.hpp"
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
  bool merge_layers;     ///< thin layers are taken together in the sweep
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
  std::vector<int> sublayers;  ///< number of equal parts per merged layer
  AngularResolution angles;

  bool operator==(const DiscretisationKey&) const = default;
};

/// Chooses the discretisation of a column: layers split until each part's scaled optical depth is below
/// the quality's step, angles fine enough for its phase functions. [docs/validation.md, "Convergence"]
DiscretisationKey discretisation_for(const Shells& shells, const OpticalColumn& column, Quality quality);

/// Lengths of the sunbeam in the layers of the medium, at every point where the sweep needs the beam, under
/// every sun node: at the levels, and in the middle of every piece of a sublayer that lies in one layer of
/// the medium (a sublayer of merged layers has several).
class BeamGeometry {
 public:
  BeamGeometry(const ShellGeometry& layers, const ShellGeometry& sublayers,
               const std::vector<double>& sun_nodes_deg);

  /// Points: first the levels of the sublayers, then the pieces from the ground up.
  int points() const { return points_; }
  /// Path in each layer, km; null in the planet's shadow.
  const float* path_km(int point, int node) const {
    const auto at = static_cast<std::size_t>(point * nodes_ + node);
    return lit_[at] ? path_km_.data() + at * layers_ : nullptr;
  }
  const std::vector<int>& first_piece() const { return first_piece_; }  ///< per sublayer, one past the last
  const std::vector<int>& piece_layer() const { return piece_layer_; }
  const std::vector<float>& piece_thickness_km() const { return piece_thickness_km_; }

 private:
  int points_ = 0;
  int nodes_;
  std::size_t layers_;
  std::vector<int> first_piece_;
  std::vector<int> piece_layer_;
  std::vector<float> piece_thickness_km_;
  std::vector<char> lit_;
  std::vector<float> path_km_;
};

/// All geometry that the columns with one key share.
struct Discretisation {
  Discretisation(const Shells& shells, const DiscretisationKey& key, Quality quality);

  QualityLimits limits;
  Shells shells;            ///< the medium's layers, homogeneous
  LayerMerge merge;         ///< the sweep's layers, merged
  ShellGeometry layers;     ///< of the medium
  ShellGeometry sublayers;  ///< merged layers, split for the sweep
  ShellGeometry ray_steps;  ///< boundaries of layers and of sublayers, which a line of sight stops at
  std::vector<int> layer_of_sublayer;  ///< merged layer
  AngularGrid angles;
  std::vector<double> sun_nodes_deg;
  SweepStencil stencil;
  BeamGeometry beam;
};

}  // namespace skylut::transfer
