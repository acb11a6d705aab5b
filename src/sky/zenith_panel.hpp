#pragma once

#include <span>
#include <vector>

namespace skylut {

/// A range of zenith angles in which a sky's smooth parts are polynomials of one coordinate, known at its
/// Chebyshev-Lobatto points. Panels end where the parts have kinks: at the local horizon, at the horizon's
/// edge and, below the local horizontal, where a line of sight begins to touch another layer.
///
/// The coordinate x in [-1, 1] is linear in
/// - the elevation e of the line, above the horizontal; in one panel for the whole dome ln(1 + e/1.5°), in
///   which what changes with the air mass is spread evenly;
/// - u = √((top - p)/(top - bottom)) of its lowest altitude p, between the horizontal and the horizon: with
/// the
///   square root a path begins at a layer's boundary;
/// - the elevation at which it meets the ground, below the horizon.
class ZenithPanel {
 public:
  enum class Kind { above, dome, limb, ground };

  /// @param from, to  elevations in degrees (above, dome, ground) or lowest altitudes in km (limb: from > to)
  ZenithPanel(Kind kind, double from, double to, double observer_km, double planet_radius_km);

  /// All from the zenith to the horizontal.
  static ZenithPanel whole_dome(double observer_km, double planet_radius_km);
  /// All from the horizontal to the geometric horizon, whatever the layers. @param observer_km  > 0
  static ZenithPanel whole_limb(double observer_km, double planet_radius_km);

  Kind kind() const { return kind_; }
  double zenith_deg(double x) const;
  double coordinate(double zenith_deg) const;
  /// Its zenith angles lie between these.
  double lowest_zenith_deg() const { return lowest_; }
  double highest_zenith_deg() const { return highest_; }

  /// Both halves, divided at x = 0.
  std::vector<ZenithPanel> halves() const;

 private:
  double from_coordinate(double natural) const;

  Kind kind_;
  double first_;  // of the natural coordinate, at x = -1
  double last_;
  double top_km_ = 0.0;     // limb
  double bottom_km_ = 0.0;  // limb
  double observer_km_;
  double planet_km_;
  double lowest_ = 0.0;
  double highest_ = 0.0;

  double natural_of(double zenith_deg) const;
  void set_range();
};

/// The panels of a whole sphere around an observer, by ascending zenith angle.
/// @param levels_km  of the layers, ascending from 0
std::vector<ZenithPanel> zenith_panels(std::span<const double> levels_km, double observer_km,
                                       double planet_radius_km);

/// Chebyshev-Lobatto points -cos(πj/(n-1)).
std::vector<double> lobatto_points(int count);

/// Weights of the interpolating polynomial through the Lobatto points at x: barycentric (Berrut & Trefethen
/// 2004, doi:10.1137/S0036144502417715).
void lobatto_weights(double x, std::span<const double> points, std::span<double> weights);

}  // namespace skylut
