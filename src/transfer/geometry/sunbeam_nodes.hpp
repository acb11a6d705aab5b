#pragma once

#include "ray_view.hpp"
#include "shell_geometry.hpp"

namespace skylut::transfer {

/// Where properties of sunbeams are tabulated that add up along the way, and how they are interpolated there.
/// The beams' lines are straight among the shells. [theory.md §4.6, B1-B4]
///
/// A sunbeam's line through a point X is known by X's altitude h and s = X·S, the point's height in the
/// direction S of the sun. Upwards (s >= 0) nodes lie at every level, in w, the s of the line where it
/// crosses that level: every path is √(w² + r_j² - r_k²), smooth in x = w/(w + w0). A point inside a layer
/// adds its way to the level above. A sunbeam that comes from below (s < 0) has crossed the whole line
/// through its lowest point less the part above X: half-lines from every lowest altitude p have nodes within
/// each layer in u = √((h_top - p)/(h_top - h_bottom)), in which the square root with which a path begins at
/// a layer's boundary is a straight line.
class SunbeamNodes {
 public:
  explicit SunbeamNodes(const ShellGeometry& layers);

  /// A sunbeam where it leaves a node upwards, and what its tabulated value is multiplied by.
  struct Node {
    double altitude_km;
    double along_sun_km;
    double scale;
  };
  int level_nodes() const;
  int perigee_nodes() const;
  Node level_node(int index) const;
  Node perigee_node(int index) const;

  /// Interpolation from a point to the sun. The sun must reach the point.
  /// @param altitude_km    of the point, 0 to the top
  /// @param along_sun_km  s
  SlantDepthWeights weights(double altitude_km, double along_sun_km) const;

  /// Lowest altitude of the sunbeam's line through a point; at most the point's own.
  double perigee_km(double altitude_km, double along_sun_km) const;

  const ShellGeometry& layers() const { return *layers_; }

  /// Nodes of both kinds.
  static double count(double layers);

 private:
  const ShellGeometry* layers_;
  double scale_km_;  // w0
  double last_x_;
};

}  // namespace skylut::transfer
