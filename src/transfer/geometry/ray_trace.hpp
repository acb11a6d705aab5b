#pragma once

#include <vector>

#include "refractive_shells.hpp"
#include "shell_geometry.hpp"

namespace skylut::transfer {

/// A point of a line of sight.
struct RayPoint {
  double distance_km;  ///< from the observer
  double altitude_km;
  double cos_view;          ///< local cosine of the direction of view
  double turned_rad = 0.0;  ///< of a bent line: angle at the planet's centre between it and the observer
};

/// Points of a bent line of sight. [docs/refraction.md §4]
class BentLine {
 public:
  /// @param shells    must outlive this object
  /// @param cos_view  apparent: of the line where it meets the observer
  BentLine(const RefractiveShells& shells, double observer_km, double cos_view);

  /// @param along_km  x cos ψ at the point, rising along the line
  RayPoint at(double along_km) const;
  double along_km(const RayPoint& point) const;

 private:
  /// Length and angle at the centre, from the lowest level or point to w.
  struct Way {
    double length_km;
    double turned_rad;
  };
  Way way_to(double optical_km, double along_km) const;

  const RefractiveShells* shells_;
  double start_along_km_;
  double impact_km_;  // b
  double optical_observer_km_;
  std::vector<Way> to_level_;  // 0 for levels that the line does not reach
  Way start_{};
};

/// A line of sight from the observer to the top of the atmosphere or to the ground. [theory.md §4.6, G9]
struct RayTrace {
  /// Stops at every level crossed, at the lowest point, and at least every longest_step_km.
  RayTrace(const ShellGeometry& levels, double longest_step_km, double observer_km, double cos_view);
  /// The same bent, with an apparent cosine. @param levels  among them all of the air's
  RayTrace(const RefractiveShells& air, const ShellGeometry& levels, double longest_step_km,
           double observer_km, double cos_view);

  std::vector<RayPoint> points;  ///< at ascending distances, no two at the same
  bool hits_ground = false;
};

}  // namespace skylut::transfer
