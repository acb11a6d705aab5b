#include "sunlit_ray.hpp"

#include <algorithm>
#include <cmath>

namespace skylut::transfer {

namespace {

/// Number of parts that a segment needs, from the lowest altitudes of the sunbeam's line at its ends and from
/// how far they lie below the ends. A sunbeam's path in a layer begins like the square root of the height
/// above its lowest altitude, so it is the change of that altitude that counts. The path is the straighter,
/// the deeper it lies below the ends of a sunbeam that comes from above; and the higher it lies, the thinner
/// is the air.
int pieces_of(double near_perigee_km, double far_perigee_km, double least_drop_km, bool from_above,
              double sunbeam_step_km) {
  const double straightness = from_above ? least_drop_km / 1.6 : 0.0;
  const double thinness = std::min(near_perigee_km, far_perigee_km) / 16.0;
  const double step_km = sunbeam_step_km * std::max({1.0, straightness, thinness});
  return std::max(1, static_cast<int>(std::ceil(std::abs(far_perigee_km - near_perigee_km) / step_km)));
}

}  // namespace

SunlitRay::SunlitRay(const SlantDepthGrid& slant_depth, double planet_radius_km, const RayPoint& start,
                     double sun_zenith_rad, double relative_azimuth_rad)
    : slant_depth_(&slant_depth),
      planet_km_(planet_radius_km),
      start_km_(start.altitude_km),
      radius_km_(planet_radius_km + start.altitude_km),
      cos_view_(start.cos_view),
      cos_sun_(std::cos(sun_zenith_rad)),
      cos_scattering_(cos_view_ * cos_sun_ + std::sqrt(std::max(0.0, 1.0 - cos_view_ * cos_view_)) *
                                                 std::sin(sun_zenith_rad) * std::cos(relative_azimuth_rad)),
      quadratic_(1.0 - cos_scattering_ * cos_scattering_),
      linear_(radius_km_ * (cos_view_ - cos_sun_ * cos_scattering_)),
      constant_(start_km_ * (2.0 * planet_km_ + start_km_) - radius_km_ * radius_km_ * cos_sun_ * cos_sun_) {}

double SunlitRay::altitude_km(double distance_km) const {
  // r² - r₀² = d² + 2 d r₀ cosθ: the difference keeps h accurate.
  const double gained = distance_km * (distance_km + 2.0 * radius_km_ * cos_view_);
  return start_km_ + gained / (std::sqrt(radius_km_ * radius_km_ + gained) + radius_km_);
}

void SunlitRay::append_parts(const std::vector<RayPoint>& points, double sunbeam_step_km, int pair,
                             std::vector<std::vector<LitPart>>& parts,
                             std::vector<SlantDepthWeights>& ends) const {
  std::vector<double> edges;  // of the shadow, where the ray crosses its cylinder behind the planet
  const double discriminant = linear_ * linear_ - quadratic_ * constant_;
  if (quadratic_ > 1e-14 && discriminant > 0.0)
    for (const double root : {-std::sqrt(discriminant), std::sqrt(discriminant)})
      if (const double edge = (root - linear_) / quadratic_; along_sun_km(edge) < 0.0) edges.push_back(edge);

  const auto perigee_of = [&](const RayPoint& point) {
    return slant_depth_->perigee_km(point.altitude_km, along_sun_km(point.distance_km));
  };
  const auto add_end = [&](const RayPoint& point) {
    ends.push_back(slant_depth_->weights(point.altitude_km, along_sun_km(point.distance_km)));
  };
  bool continues = false;
  const auto append = [&](std::size_t segment, const RayPoint& segment_start, const RayPoint& near,
                          const RayPoint& far) {
    if (!lit(0.5 * (near.distance_km + far.distance_km))) {
      continues = false;
      return;
    }
    if (!continues) add_end(near);
    const bool from_above = along_sun_km(near.distance_km) >= 0.0 && along_sun_km(far.distance_km) >= 0.0;
    const double near_perigee = perigee_of(near);
    const double far_perigee = perigee_of(far);
    const double least_drop = std::min(near.altitude_km - near_perigee, far.altitude_km - far_perigee);
    const int pieces = pieces_of(near_perigee, far_perigee, least_drop, from_above, sunbeam_step_km);
    RayPoint from = near;
    for (int piece = 1; piece <= pieces; ++piece) {
      RayPoint to = far;
      if (piece < pieces) {
        to.distance_km = near.distance_km + (far.distance_km - near.distance_km) * piece / pieces;
        to.altitude_km = altitude_km(to.distance_km);
      }
      parts[segment].push_back({pair, static_cast<int>(ends.size()) - 1, continues,
                                static_cast<float>(from.distance_km - segment_start.distance_km),
                                static_cast<float>(to.distance_km - from.distance_km)});
      continues = true;
      add_end(to);
      from = to;
    }
  };

  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    RayPoint near = points[i];
    for (const double edge : edges)
      if (edge > points[i].distance_km && edge < points[i + 1].distance_km) {
        const RayPoint at_edge{edge, altitude_km(edge), 0.0};
        append(i, points[i], near, at_edge);
        near = at_edge;
      }
    append(i, points[i], near, points[i + 1]);
  }
}

}  // namespace skylut::transfer
