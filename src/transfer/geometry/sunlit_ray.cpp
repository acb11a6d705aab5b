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

double cos_between(double cos_view, double cos_sun, double sin_sun, double cos_azimuth) {
  return cos_view * cos_sun + std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view)) * sin_sun * cos_azimuth;
}

}  // namespace

SunlitRay::SunlitRay(const SlantDepthGrid& slant_depth, double planet_radius_km, const RayPoint& start,
                     double sun_zenith_rad, double relative_azimuth_rad, const BentLine* bent)
    : slant_depth_(&slant_depth),
      bent_(bent),
      planet_km_(planet_radius_km),
      start_km_(start.altitude_km),
      radius_km_(planet_radius_km + start.altitude_km),
      cos_view_(start.cos_view),
      cos_sun_(std::cos(sun_zenith_rad)),
      sun_towards_view_(std::sin(sun_zenith_rad) * std::cos(relative_azimuth_rad)),
      cos_scattering_(
          cos_between(cos_view_, cos_sun_, std::sin(sun_zenith_rad), std::cos(relative_azimuth_rad))),
      quadratic_(1.0 - cos_scattering_ * cos_scattering_),
      linear_(radius_km_ * (cos_view_ - cos_sun_ * cos_scattering_)),
      constant_(start_km_ * (2.0 * planet_km_ + start_km_) - radius_km_ * radius_km_ * cos_sun_ * cos_sun_) {
  if (bent_ == nullptr) return;
  const double apparent = slant_depth.refraction()->apparent_sun_rad(start_km_, sun_zenith_rad);
  cos_scattering_ =
      cos_between(cos_view_, std::cos(apparent), std::sin(apparent), std::cos(relative_azimuth_rad));
}

double SunlitRay::along_sun_km(const RayPoint& point) const {
  if (bent_ == nullptr) return radius_km_ * cos_sun_ + point.distance_km * cos_scattering_;
  return (planet_km_ + point.altitude_km) *
         (std::cos(point.turned_rad) * cos_sun_ + std::sin(point.turned_rad) * sun_towards_view_);
}

double SunlitRay::altitude_km(double distance_km) const {
  // r² - r₀² = d² + 2 d r₀ cosθ: the difference keeps h accurate.
  const double gained = distance_km * (distance_km + 2.0 * radius_km_ * cos_view_);
  return start_km_ + gained / (std::sqrt(radius_km_ * radius_km_ + gained) + radius_km_);
}

RayPoint SunlitRay::between(const RayPoint& near, const RayPoint& far, int part, int parts) const {
  if (bent_ != nullptr) {
    const double along = bent_->along_km(near);
    return bent_->at(along + (bent_->along_km(far) - along) * part / parts);
  }
  RayPoint point = far;
  point.distance_km = near.distance_km + (far.distance_km - near.distance_km) * part / parts;
  point.altitude_km = altitude_km(point.distance_km);
  return point;
}

bool SunlitRay::lit_between(const RayPoint& near, const RayPoint& far) const {
  if (bent_ == nullptr) {
    const double distance_km = 0.5 * (near.distance_km + far.distance_km);
    return radius_km_ * cos_sun_ + distance_km * cos_scattering_ >= 0.0 || beyond_shadow(distance_km) >= 0.0;
  }
  if (along_sun_km(near) >= 0.0 && along_sun_km(far) >= 0.0) return true;
  const RayPoint middle = between(near, far, 1, 2);
  return slant_depth_->is_lit(middle.altitude_km, along_sun_km(middle));
}

RayPoint SunlitRay::edge_between(RayPoint lit, RayPoint dark) const {
  constexpr double kEdge_km = 1e-3;
  while (std::abs(dark.distance_km - lit.distance_km) > kEdge_km) {
    const RayPoint middle = between(lit, dark, 1, 2);
    (slant_depth_->is_lit(middle.altitude_km, along_sun_km(middle)) ? lit : dark) = middle;
  }
  return lit;
}

std::vector<RayPoint> SunlitRay::shadow_edges(const std::vector<RayPoint>& points) const {
  std::vector<RayPoint> edges;
  if (bent_ != nullptr) {
    // Where the line dives into the shadow and out again between two points, it is less than their distance
    // squared over 8 R deep in it: two metres.
    bool near_lit = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool lit = slant_depth_->is_lit(points[i].altitude_km, along_sun_km(points[i]));
      if (i > 0 && lit != near_lit)
        edges.push_back(lit ? edge_between(points[i], points[i - 1])
                            : edge_between(points[i - 1], points[i]));
      near_lit = lit;
    }
    return edges;
  }
  // Where the ray crosses the shadow's cylinder behind the planet.
  const double discriminant = linear_ * linear_ - quadratic_ * constant_;
  if (quadratic_ > 1e-14 && discriminant > 0.0)
    for (const double root : {-std::sqrt(discriminant), std::sqrt(discriminant)})
      if (const double edge = (root - linear_) / quadratic_;
          radius_km_ * cos_sun_ + edge * cos_scattering_ < 0.0)
        edges.push_back({edge, altitude_km(edge), 0.0});
  return edges;
}

void SunlitRay::append_parts(const std::vector<RayPoint>& points, double sunbeam_step_km, int pair,
                             std::vector<std::vector<LitPart>>& parts,
                             std::vector<SlantDepthWeights>& ends) const {
  struct End {
    RayPoint point;
    Sunbeam beam;
  };
  const auto end_at = [&](const RayPoint& point) -> End {
    return {point, slant_depth_->sunbeam(point.altitude_km, along_sun_km(point))};
  };
  bool continues = false;
  End last{};  // of the part that was appended before
  const auto append = [&](std::size_t segment, const RayPoint& segment_start, const RayPoint& near_point,
                          const RayPoint& far_point) {
    if (!lit_between(near_point, far_point)) {
      continues = false;
      return;
    }
    const End near = continues ? last : end_at(near_point);
    const End far = end_at(far_point);
    if (!continues) ends.push_back(slant_depth_->weights(near.beam));
    const bool from_above = near.beam.along_sun_km >= 0.0 && far.beam.along_sun_km >= 0.0;
    const double near_perigee = slant_depth_->perigee_km(near.beam);
    const double far_perigee = slant_depth_->perigee_km(far.beam);
    const double least_drop =
        std::min(near.beam.altitude_km - near_perigee, far.beam.altitude_km - far_perigee);
    const int pieces = pieces_of(near_perigee, far_perigee, least_drop, from_above, sunbeam_step_km);
    RayPoint from = near_point;
    for (int piece = 1; piece <= pieces; ++piece) {
      const End to = piece < pieces ? end_at(between(near_point, far_point, piece, pieces)) : far;
      parts[segment].push_back({pair, static_cast<int>(ends.size()) - 1, continues,
                                static_cast<float>(from.distance_km - segment_start.distance_km),
                                static_cast<float>(to.point.distance_km - from.distance_km)});
      continues = true;
      ends.push_back(slant_depth_->weights(to.beam));
      from = to.point;
    }
    last = far;
  };

  const std::vector<RayPoint> edges = shadow_edges(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    RayPoint near = points[i];
    for (const RayPoint& edge : edges)
      if (edge.distance_km > points[i].distance_km && edge.distance_km < points[i + 1].distance_km) {
        append(i, points[i], near, edge);
        near = edge;
      }
    append(i, points[i], near, points[i + 1]);
  }
}

}  // namespace skylut::transfer
