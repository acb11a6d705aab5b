#pragma once

#include <vector>

#include "ray_trace.hpp"
#include "ray_view.hpp"
#include "slant_depth_grid.hpp"

namespace skylut::transfer {

/// The parts of a line of sight that one sun reaches. The line starts at (0, 0, r₀) and runs in the direction
/// V, the sun is in the direction S; X is a point of the line. [theory.md §4.6, G10, G12-G13] Of a bent line
/// X is known by the angle it has turned about the planet's centre. [docs/refraction.md §4]
class SunlitRay {
 public:
  /// @param start  where the ray starts
  /// @param bent   none: the ray is straight; must outlive this object
  SunlitRay(const SlantDepthGrid& slant_depth, double planet_radius_km, const RayPoint& start,
            double sun_zenith_rad, double relative_azimuth_rad, const BentLine* bent = nullptr);

  /// Cosine of the scattering angle: the light travels along -V, the beam along -S, all along the ray. Bent
  /// rays: of the angle between view and sun as they appear to the observer.
  double cos_scattering() const { return cos_scattering_; }

  /// Cosine of the local solar zenith angle.
  double cos_sun(const RayPoint& point) const {
    return along_sun_km(point) / (planet_km_ + point.altitude_km);
  }

  /// Appends the lit parts of the segments between the points to those of each segment, and their ends: cut
  /// at the edges of the planet's shadow, and finely where the sunbeam grazes the ground, since its optical
  /// depth changes fast there.
  void append_parts(const std::vector<RayPoint>& points, double sunbeam_step_km, int pair,
                    std::vector<std::vector<LitPart>>& parts, std::vector<SlantDepthWeights>& ends) const;

 private:
  double along_sun_km(const RayPoint& point) const;  // X·S
  double altitude_km(double distance_km) const;      // of a straight ray
  double beyond_shadow(double distance_km) const {
    return (quadratic_ * distance_km + 2.0 * linear_) * distance_km + constant_;
  }
  bool lit_between(const RayPoint& near, const RayPoint& far) const;
  /// The end of the first `part` of `parts` even ones.
  RayPoint between(const RayPoint& near, const RayPoint& far, int part, int parts) const;
  std::vector<RayPoint> shadow_edges(const std::vector<RayPoint>& points) const;
  RayPoint edge_between(RayPoint lit, RayPoint dark) const;

  const SlantDepthGrid* slant_depth_;
  const BentLine* bent_;
  double planet_km_;
  double start_km_;
  double radius_km_;
  double cos_view_;
  double cos_sun_;
  double sun_towards_view_;  // sin of the sun's zenith angle, times the cosine of its azimuth from the view
  double cos_scattering_;    // V·S
  // |X|² - (X·S)² - R², as a quadratic in the distance: negative inside the shadow's cylinder.
  double quadratic_;
  double linear_;
  double constant_;
};

}  // namespace skylut::transfer
