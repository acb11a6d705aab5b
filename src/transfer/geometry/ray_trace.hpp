#pragma once

#include <vector>

#include "shell_geometry.hpp"

namespace skylut::transfer {

/// A point of a line of sight.
struct RayPoint {
  double distance_km;  ///< from the observer
  double altitude_km;
  double cos_view;  ///< local cosine of the direction of view
};

/// A line of sight from the observer to the top of the atmosphere or to the ground. [theory.md §4.6, G9]
struct RayTrace {
  /// Stops at every level crossed, at the lowest point, and at least every longest_step_km.
  RayTrace(const ShellGeometry& levels, double longest_step_km, double observer_km, double cos_view);

  std::vector<RayPoint> points;  ///< at ascending distances, no two at the same
  bool hits_ground = false;
};

}  // namespace skylut::transfer
