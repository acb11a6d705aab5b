#include "sunlit_ray.hpp"

#include <algorithm>
#include <cmath>

namespace skylut::transfer {

namespace {

/// Where the sunbeam's lowest altitude lies within this of the ground, its optical depth changes fast.
constexpr double kGrazing_km = 60.0;
/// Beyond this the change slows down in proportion to the distance.
constexpr double kSteepest_km = 16.0;

/// Number of parts that a segment needs between two lowest altitudes of the sunbeam.
int pieces_of(double near_perigee_km, double far_perigee_km, double sunbeam_step_km) {
  const double least = std::min(near_perigee_km, far_perigee_km);
  const double most = std::max(near_perigee_km, far_perigee_km);
  if (most < -kGrazing_km || least > kGrazing_km) return 1;
  const double distance_km = std::max({0.0, least, -most});
  const double step_km = sunbeam_step_km * std::max(1.0, distance_km / kSteepest_km);
  return std::max(1, static_cast<int>(std::ceil((most - least) / step_km)));
}

}  // namespace

SunlitRay::SunlitRay(double planet_radius_km, const RayPoint& start, double sun_zenith_rad,
                     double relative_azimuth_rad)
    : planet_km_(planet_radius_km),
      start_km_(start.altitude_km),
      radius_km_(planet_radius_km + start.altitude_km),
      cos_view_(start.cos_view),
      cos_sun_(std::cos(sun_zenith_rad)),
      view_to_sun_(cos_view_ * cos_sun_ + std::sqrt(std::max(0.0, 1.0 - cos_view_ * cos_view_)) *
                                              std::sin(sun_zenith_rad) * std::cos(relative_azimuth_rad)),
      quadratic_(1.0 - view_to_sun_ * view_to_sun_),
      linear_(radius_km_ * (cos_view_ - cos_sun_ * view_to_sun_)),
      constant_(start_km_ * (2.0 * planet_km_ + start_km_) - radius_km_ * radius_km_ * cos_sun_ * cos_sun_) {}

double SunlitRay::perigee_km(double distance_km, double altitude_km) const {
  const double local = planet_km_ + altitude_km;
  const double height = sun_height(distance_km);
  const double perigee_radius = std::sqrt(std::max(0.0, local * local - height * height));
  // p - R without cancellation: (p² - R²)/(p + R).
  const double perigee =
      (altitude_km * (2.0 * planet_km_ + altitude_km) - height * height) / (perigee_radius + planet_km_);
  return std::min(perigee, altitude_km);
}

double SunlitRay::altitude_km(double distance_km) const {
  // r² - r₀² = d² + 2 d r₀ cosθ: the difference keeps h accurate.
  const double gained = distance_km * (distance_km + 2.0 * radius_km_ * cos_view_);
  return start_km_ + gained / (std::sqrt(radius_km_ * radius_km_ + gained) + radius_km_);
}

void SunlitRay::append_parts(const std::vector<RayPoint>& points, double sunbeam_step_km,
                             std::vector<LitPart>& parts) const {
  std::vector<double> edges;  // of the shadow, where the ray crosses its cylinder behind the planet
  const double discriminant = linear_ * linear_ - quadratic_ * constant_;
  if (quadratic_ > 1e-14 && discriminant > 0.0)
    for (const double root : {-std::sqrt(discriminant), std::sqrt(discriminant)})
      if (const double edge = (root - linear_) / quadratic_; sun_height(edge) < 0.0) edges.push_back(edge);

  bool continues = false;
  const auto append = [&](int segment, const RayPoint& segment_start, const RayPoint& near,
                          const RayPoint& far) {
    if (!lit(0.5 * (near.distance_km + far.distance_km))) {
      continues = false;
      return;
    }
    const double near_perigee = perigee_km(near.distance_km, near.altitude_km);
    const double far_perigee = perigee_km(far.distance_km, far.altitude_km);
    const int pieces = pieces_of(near_perigee, far_perigee, sunbeam_step_km);
    RayPoint from = near;
    double from_perigee = near_perigee;
    for (int piece = 1; piece <= pieces; ++piece) {
      RayPoint to = far;
      double to_perigee = far_perigee;
      if (piece < pieces) {
        to.distance_km = near.distance_km + (far.distance_km - near.distance_km) * piece / pieces;
        to.altitude_km = altitude_km(to.distance_km);
        to_perigee = perigee_km(to.distance_km, to.altitude_km);
      }
      parts.push_back({segment, static_cast<float>(to.distance_km - from.distance_km),
                       static_cast<float>(from.distance_km - segment_start.distance_km),
                       static_cast<float>(from.altitude_km), static_cast<float>(to.altitude_km),
                       static_cast<float>(from_perigee), static_cast<float>(to_perigee), continues,
                       sun_height(from.distance_km) < 0.0, sun_height(to.distance_km) < 0.0});
      continues = true;
      from = to;
      from_perigee = to_perigee;
    }
  };

  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    RayPoint near = points[i];
    for (const double edge : edges)
      if (edge > points[i].distance_km && edge < points[i + 1].distance_km) {
        const RayPoint at_edge{edge, altitude_km(edge), 0.0};
        append(static_cast<int>(i), points[i], near, at_edge);
        near = at_edge;
      }
    append(static_cast<int>(i), points[i], near, points[i + 1]);
  }
}

}  // namespace skylut::transfer
