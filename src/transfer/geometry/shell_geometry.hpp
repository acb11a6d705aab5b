#pragma once

#include <vector>

namespace skylut::transfer {

/// Straight rays through concentric shells. Lengths in km, angles as cosines; h is altitude above the
/// ground of radius R, r = R + h. [theory.md §4.1, G1-G4]
///
/// Squares of radii differ by little: every difference is formed as (h₁-h₂)(2R+h₁+h₂), which keeps full
/// accuracy for a planet of any size.
class ShellGeometry {
 public:
  ShellGeometry(std::vector<double> levels_km, double planet_radius_km);

  int levels() const { return static_cast<int>(levels_km_.size()); }
  int layers() const { return levels() - 1; }
  double level_km(int level) const { return levels_km_[static_cast<std::size_t>(level)]; }
  const std::vector<double>& levels_km() const { return levels_km_; }
  double planet_radius_km() const { return planet_radius_km_; }
  double top_km() const { return levels_km_.back(); }

  /// r_a² - r_b² for altitudes a and b.
  double radius_square_difference(double a_km, double b_km) const {
    return (a_km - b_km) * (2.0 * planet_radius_km_ + a_km + b_km);
  }

  /// Layer that holds the altitude; at a level, the layer above it (below it for the top level).
  int layer_of(double altitude_km) const;

  /// Length in each layer of the ray from altitude_km towards a point at infinity whose local zenith has
  /// the cosine cos_zenith. Down-going rays pass their lowest point and rise again.
  /// @return false, leaving `length_km` untouched, if the ray meets the ground
  bool path_to_top(double altitude_km, double cos_zenith, std::vector<double>& length_km) const;

 private:
  std::vector<double> levels_km_;
  double planet_radius_km_;
};

}  // namespace skylut::transfer
