#pragma once

#include <memory>
#include <vector>

#include "ray_view.hpp"
#include "shell_geometry.hpp"
#include "sun_refraction.hpp"
#include "sunbeam_nodes.hpp"

namespace skylut::transfer {

/// Where the optical depth towards the sun is tabulated, so that a point costs a few multiplications
/// instead of a sum over all layers: at SunbeamNodes. Bent sunbeams are straight among optical shells; the
/// weights of a point then carry how much the air spreads the light, too. [theory.md §4.6, B1-B4;
/// docs/refraction.md §3]
class SlantDepthGrid {
 public:
  /// @param layers  must outlive this object
  explicit SlantDepthGrid(const ShellGeometry& layers);
  explicit SlantDepthGrid(const RefractiveShells& shells);

  /// The sunbeam that reaches a point. The sun must reach the point.
  /// @param altitude_km    of the point, 0 to the top
  /// @param along_sun_km  s = (R + h) cos(local solar zenith angle)
  Sunbeam sunbeam(double altitude_km, double along_sun_km) const;

  /// Interpolation of the depth from a point to the sun.
  SlantDepthWeights weights(const Sunbeam& sunbeam) const;
  SlantDepthWeights weights(double altitude_km, double along_sun_km) const {
    return weights(sunbeam(altitude_km, along_sun_km));
  }

  /// The same for a direction: the sun at a local zenith angle. Not lit in the planet's shadow.
  SlantDepthWeights weights_towards(double altitude_km, double cos_sun_zenith) const;

  /// Cosine of the apparent sun's local zenith angle (SunRefraction::apparent_sun_rad).
  double cos_apparent_sun(double altitude_km, double cos_sun_zenith) const;
  /// The same angle in degrees; straight beams: as it was given.
  double apparent_sun_deg(double altitude_km, double sun_zenith_deg) const;
  /// Whether the ground does not hide the sun.
  bool is_lit(double altitude_km, double along_sun_km) const;

  /// Lowest altitude of the sunbeam's line; at most the point's own.
  double perigee_km(const Sunbeam& sunbeam) const {
    return nodes_.perigee_km(sunbeam.altitude_km, sunbeam.along_sun_km);
  }
  double perigee_km(double altitude_km, double along_sun_km) const {
    return perigee_km(sunbeam(altitude_km, along_sun_km));
  }

  /// Of bent sunbeams; none: they are straight.
  const SunRefraction* refraction() const { return refraction_.get(); }

  SlantDepthView view() const;

  /// Entries of both tables, each of them a path through every layer.
  static double points(double layers) { return SunbeamNodes::count(layers); }

 private:
  void fill();
  void add_path(const SunbeamNodes::Node& node, std::vector<float>& to) const;

  SunbeamNodes nodes_;
  std::vector<double> stretch_;  // length over that among the nodes' shells [layer]; empty: 1
  std::unique_ptr<const SunRefraction> refraction_;
  double planet_km_;
  std::vector<float> from_level_path_km_;    // [level][node][layer], scaled
  std::vector<float> from_perigee_path_km_;  // [layer][node][layer]
};

}  // namespace skylut::transfer
