#pragma once

#include <optional>
#include <vector>

#include "../geometry/interpolation.hpp"
#include "../geometry/shell_geometry.hpp"
#include "angular_grid.hpp"
#include "common_grid.hpp"
#include "horizon_peak.hpp"
#include "polarised_angles.hpp"
#include "sweep_stencil.hpp"

namespace skylut::transfer {

/// What fixes the discretisation of a column. It follows from the column alone, never from the other
/// columns: that is what makes results independent of the batch. Columns with equal keys share the
/// geometry and may share a block of lanes.
struct DiscretisationKey {
  /// Number of parts per merged layer; equal ones, or in thick layers the finest.
  std::vector<int> sublayers;
  bool grades_top = false;  ///< thinner sublayers at the top, where the medium ends abruptly
  AngularResolution angles;
  bool cuts_peak = false;    ///< delta-M takes a forward peak that matters at the horizon
  int polarised_degree = 0;  ///< highest degree of Q and U; 0: light is taken for unpolarised

  bool operator==(const DiscretisationKey&) const = default;
};

/// Chooses the discretisation of a column: layers split until each part's scaled optical depth is below
/// the quality's step, and thick layers of an even medium by their thickness; angles fine enough for its
/// phase functions. [docs/validation.md, "Convergence"]
/// @param merge  the layers of the sweep
DiscretisationKey discretisation_for(const LayerMerge& merge, const DiscretisationOptions& options,
                                     const OpticalColumn& column);

/// How many sublayers a column is swept in, and how thick they get.
struct SublayerSizes {
  double count = 0.0;
  double thickest_km = 0.0;
};
/// @param merged  the layers of the sweep
SublayerSizes sublayer_sizes(const Shells& merged, const DiscretisationKey& key);

/// The sunbeam at every point where the sweep needs it, under every sun node: at the levels, and in the
/// middle of every piece of a sublayer that lies in one layer of the medium (a sublayer of merged layers has
/// several).
class BeamGeometry {
 public:
  BeamGeometry(const CommonGrid& common, const ShellGeometry& sublayers);

  /// [point][sun node]; points: first the levels of the sublayers, then the pieces from the ground up.
  const std::vector<SlantDepthWeights>& weights() const { return weights_; }
  const std::vector<int>& first_piece() const { return first_piece_; }  ///< per sublayer, one past the last
  const std::vector<int>& piece_layer() const { return piece_layer_; }
  const std::vector<float>& piece_thickness_km() const { return piece_thickness_km_; }

 private:
  std::vector<SlantDepthWeights> weights_;
  std::vector<int> first_piece_;
  std::vector<int> piece_layer_;
  std::vector<float> piece_thickness_km_;
};

/// All geometry that the columns with one key share.
struct Discretisation {
  /// @param medium  must outlive the discretisation
  Discretisation(const CommonGrid& common, const DiscretisationKey& key);

  /// Whether a line of sight asks the diffuse field at an altitude where it stops: at the boundaries of
  /// sublayers and between levels (steps of a long ray), but not at the boundaries that are the medium's
  /// alone, across which the field's moments are linear.
  bool needs_source_at(double altitude_km) const;

  const CommonGrid& common;
  ShellGeometry sublayers;             ///< merged layers, split for the sweep
  ShellGeometry ray_levels;            ///< boundaries of the medium's layers and of the sublayers
  std::vector<int> layer_of_sublayer;  ///< merged layer
  AngularGrid angles;
  std::optional<PolarisedAngles> polarised;
  bool cuts_peak;
  HorizonNodes horizon;
  SweepStencil stencil;
  BeamGeometry beam;
};

}  // namespace skylut::transfer
