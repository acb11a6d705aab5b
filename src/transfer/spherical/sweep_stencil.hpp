#pragma once

#include <vector>

#include "../geometry/interpolation.hpp"
#include "../geometry/shell_geometry.hpp"
#include "angular_grid.hpp"

namespace skylut::transfer {

/// Where the light of one polar node comes from when it has crossed one sublayer.
struct PolarStep {
  float length_km;              ///< of the straight ray through the sublayer
  bool chord;                   ///< the ray entered through the upper boundary that it also leaves by
  InterpolationWeights upwind;  ///< among the polar nodes of the same hemisphere; unused for a chord
};

/// Short characteristics through every sublayer: for each direction of the sweep, the length of the ray
/// and the place (polar angle, solar zenith angle) where it entered. Pure geometry, shared by all lanes.
/// [theory.md §4.4, G5-G8]
class SweepStencil {
 public:
  /// @param shells       boundaries of the sublayers
  /// @param sun_nodes_deg  local solar zenith angles that carry the field, ascending
  SweepStencil(const ShellGeometry& shells, const AngularGrid& angles,
               const std::vector<double>& sun_nodes_deg);

  /// Polar node j of a ray that leaves sublayer `layer` downwards (through its lower boundary) or upwards.
  const PolarStep& polar(Hemisphere hemisphere, int layer, int j) const {
    return polar_[hemisphere][static_cast<std::size_t>(layer * polar_nodes_ + j)];
  }
  /// Weights among the sun nodes for all directions [polar][azimuth] of one sublayer and sun node.
  const InterpolationWeights* sun(Hemisphere hemisphere, int layer, int node) const {
    return sun_[hemisphere].data() + static_cast<std::size_t>(layer * sun_nodes_ + node) * directions_;
  }
  /// Number of polar nodes, from the horizon up, that are chords of some sublayer.
  int chord_nodes() const { return chord_nodes_; }

 private:
  int polar_nodes_;
  int sun_nodes_;
  std::size_t directions_;
  int chord_nodes_ = 0;
  std::vector<PolarStep> polar_[2];
  std::vector<InterpolationWeights> sun_[2];
};

}  // namespace skylut::transfer
