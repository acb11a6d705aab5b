#pragma once

#include <vector>

#include "ray_trace.hpp"
#include "ray_view.hpp"
#include "slant_depth_grid.hpp"

namespace skylut::transfer {

/// The parts of a line of sight that one sun reaches. The ray starts at (0, 0, r₀) and runs in the direction
/// V, the sun is in the direction S; X is a point of the ray. [theory.md §4.6, G10, G12-G13]
class SunlitRay {
 public:
  /// @param start  where the ray starts
  SunlitRay(const SlantDepthGrid& slant_depth, double planet_radius_km, const RayPoint& start,
            double sun_zenith_rad, double relative_azimuth_rad);

  /// Cosine of the scattering angle: the light travels along -V, the beam along -S, all along the ray.
  double cos_scattering() const { return cos_scattering_; }

  /// Cosine of the local solar zenith angle.
  double cos_sun(double distance_km, double altitude_km) const {
    return along_sun_km(distance_km) / (planet_km_ + altitude_km);
  }

  /// Appends the lit parts of the segments between the points to those of each segment, and their ends: cut
  /// at the edges of the planet's shadow, and finely where the sunbeam grazes the ground, since its optical
  /// depth changes fast there.
  void append_parts(const std::vector<RayPoint>& points, double sunbeam_step_km, int pair,
                    std::vector<std::vector<LitPart>>& parts, std::vector<SlantDepthWeights>& ends) const;

 private:
  double along_sun_km(double distance_km) const {
    return radius_km_ * cos_sun_ + distance_km * cos_scattering_;
  }  // X·S
  double altitude_km(double distance_km) const;
  double beyond_shadow(double distance_km) const {
    return (quadratic_ * distance_km + 2.0 * linear_) * distance_km + constant_;
  }
  bool lit(double distance_km) const {
    return along_sun_km(distance_km) >= 0.0 || beyond_shadow(distance_km) >= 0.0;
  }

  const SlantDepthGrid* slant_depth_;
  double planet_km_;
  double start_km_;
  double radius_km_;
  double cos_view_;
  double cos_sun_;
  double cos_scattering_;  // V·S
  // |X|² - (X·S)² - R², as a quadratic in the distance: negative inside the shadow's cylinder.
  double quadratic_;
  double linear_;
  double constant_;
};

}  // namespace skylut::transfer
