#pragma once

#include <span>
#include <vector>

#include "../geometry/interpolation.hpp"
#include "../geometry/shell_geometry.hpp"
#include "angular_grid.hpp"
#include "kernel_problem.hpp"
#include "skylut/scattering/optical_column.hpp"

namespace skylut::transfer {

// Delta-M takes the forward peak for light that goes straight on. Close to the horizon the radiance jumps
// within the peak's width, from the sky to the dark ground, and what the peak scatters into a grazing line of
// sight comes from both. With P_peak = Σ (2l+1) p_l P_l, p_l = 1 up to L and χ_l/χ_{L+1} beyond, the line
// lacks the source
//   β_peak C,   C = (1/4π) ∫ P_peak(Ω·Ω') I(Ω') dΩ' - I(Ω),
// which the sweep's radiance gives at the polar nodes near the horizon (horizon_light.hpp). [theory.md §4.6,
// L6]

/// A peak smaller than this share of the scattering needs no correction: at most half of it is missing.
inline constexpr double kLeastHorizonPeak = 2e-3;

/// Levels at which C is kept.
inline constexpr int kMostHorizonLevels = 6;

/// The polar nodes and levels near the horizon and the ground, and the way in which lines of sight
/// interpolate between them.
class HorizonNodes {
 public:
  /// @param layer_of_sublayer  merged layers
  HorizonNodes(const AngularGrid& angles, const ShellGeometry& sublayers,
               const std::vector<int>& layer_of_sublayer);

  int count() const { return count_; }
  int levels() const { return static_cast<int>(altitude_km_.size()); }
  /// By level of the sweep: its place among those that are kept, or -1.
  const std::vector<int>& place_of_level() const { return place_of_level_; }
  /// By level that is kept: the merged layer above it (of the top level, below).
  const std::vector<int>& layer_of_level() const { return layer_of_level_; }
  /// @param mu  of the light, in [-1, 1]
  HorizonWeights at(double mu, double altitude_km) const;

 private:
  int count_;
  CubicInterpolation among_nodes_;   // in √|μ|
  std::vector<double> altitude_km_;  // of the levels that are kept
  std::vector<int> place_of_level_;
  std::vector<int> layer_of_level_;
};

/// What turns the radiance at the polar nodes into C: pure geometry.
class HorizonPeakTables {
 public:
  /// @param nodes  must outlive the tables
  HorizonPeakTables(const AngularGrid& angles, const HorizonNodes& nodes);

  HorizonView view() const;

 private:
  const HorizonNodes& nodes_;
  std::vector<float> synthesis_;
  std::vector<float> analysis_;
};

/// The peaks of the columns of one block; none unless made from columns.
struct HorizonPeaks {
  int peaks = 0;              ///< the most that a lane has
  std::vector<float> moment;  ///< [peak][l][lane]: p_l
  std::vector<float> share;   ///< [layer of the sweep][peak][lane]: of the peaks of the layer

  HorizonPeaks() = default;
  /// @param columns  of merged layers, one per lane
  HorizonPeaks(std::span<const OpticalColumn> columns, int max_l);
};

}  // namespace skylut::transfer
