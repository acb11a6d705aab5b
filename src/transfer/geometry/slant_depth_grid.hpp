#pragma once

#include <vector>

#include "ray_view.hpp"
#include "shell_geometry.hpp"

namespace skylut::transfer {

/// Where the optical depth towards the sun is tabulated, so that a point costs a few multiplications
/// instead of a sum over all layers. [theory.md §4.6, B1-B4]
///
/// A sunbeam's line through a point X is known by X's altitude h and s = X·S, the point's height in the
/// direction S of the sun. Upwards (s >= 0) the depth is tabulated at every level against w, the s of the
/// line where it crosses that level: every path is √(w² + r_j² - r_k²), smooth in x = w/(w + w0). A point
/// inside a layer adds its way to the level above. A sunbeam that comes from below (s < 0) has crossed the
/// whole line through its lowest point less the part above X: half-lines from every lowest altitude p are
/// tabulated within each layer against u = √((h_top - p)/(h_top - h_bottom)), in which the square root
/// with which a path begins at a layer's boundary is a straight line.
class SlantDepthGrid {
 public:
  explicit SlantDepthGrid(const ShellGeometry& layers);

  /// Interpolation of the depth from a point to the sun. The sun must reach the point.
  /// @param altitude_km    of the point, 0 to the top
  /// @param along_sun_km  s = (R + h) cos(local solar zenith angle)
  SlantDepthWeights weights(double altitude_km, double along_sun_km) const;

  /// The same for a direction: the sun at a local zenith angle. Not lit in the planet's shadow.
  SlantDepthWeights weights_towards(double altitude_km, double cos_sun_zenith) const;

  /// Lowest altitude of the sunbeam's line through a point; at most the point's own.
  double perigee_km(double altitude_km, double along_sun_km) const;

  SlantDepthView view() const;

  /// Entries of both tables, each of them a path through every layer.
  static double points(double layers);

 private:
  std::vector<float> path_to_sun(double altitude_km, double cos_zenith, double scale) const;

  const ShellGeometry* layers_;
  double scale_km_;  // w0
  double last_x_;
  std::vector<float> from_level_path_km_;    // [level][node][layer], times w + w0
  std::vector<float> from_perigee_path_km_;  // [layer][node][layer]
};

}  // namespace skylut::transfer
