#include "ray.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "skylut/core/constants.hpp"
#include "sunlit_ray.hpp"

namespace skylut::transfer {

namespace {

constexpr double kAureoleCosine = 0.9396926;  // 20°
constexpr double kFadeCosine = 0.9659258;     // 15°

}  // namespace

double aureole_weight(double cos_scattering_angle) {
  return std::clamp((cos_scattering_angle - kAureoleCosine) / (kFadeCosine - kAureoleCosine), 0.0, 1.0);
}

RayTrace RaySpace::trace(const ShellGeometry& levels, double observer_km, double cos_view) const {
  if (refractive == nullptr) return {levels, ray_step_km, observer_km, cos_view};
  return {*refractive, levels, ray_step_km, observer_km, cos_view};
}

Ray::Ray(const RaySpace& space, double observer_km, double view_zenith_deg, std::span<const SunAzimuth> pairs,
         int azimuthal_orders)
    : start_{0.0, observer_km, std::cos(view_zenith_deg * kRadiansPerDegree)},
      local_sun_(space.layers.planet_radius_km(), start_, space.refractive != nullptr, pairs,
                 space.sun_interpolation, azimuthal_orders) {
  const RayTrace trace = space.trace(space.layers, observer_km, start_.cos_view);
  std::optional<BentLine> bent;
  if (space.refractive != nullptr) bent.emplace(*space.refractive, observer_km, start_.cos_view);
  hits_ground_ = trace.hits_ground;
  for (std::size_t i = 0; i + 1 < trace.points.size(); ++i) {
    const RayPoint& near = trace.points[i];
    const RayPoint& far = trace.points[i + 1];
    segment_.push_back({space.layers.layer_of(0.5 * (near.altitude_km + far.altitude_km)),
                        static_cast<float>(far.distance_km - near.distance_km)});
  }
  const RayPoint& end = trace.points.back();
  std::vector<std::vector<LitPart>> lit(segment_.size());
  int aureoles = 0;
  for (const SunAzimuth& pair : pairs) {
    const SunlitRay ray(space.slant_depth, space.layers.planet_radius_km(), trace.points.front(),
                        pair.sun_zenith_deg * kRadiansPerDegree,
                        pair.relative_azimuth_deg * kRadiansPerDegree, bent ? &*bent : nullptr);
    ray.append_parts(trace.points, space.sunbeam_step_km, static_cast<int>(cos_scattering_.size()), lit,
                     lit_end_);
    cos_scattering_.push_back(ray.cos_scattering());
    aureole_.push_back(aureole_weight(ray.cos_scattering()) > 0.0 ? aureoles++ : -1);
    const double cosine = hits_ground_ ? ray.cos_sun({end.distance_km, 0.0, 0.0, end.turned_rad}) : -1.0;
    ground_sun_cosine_.push_back(
        static_cast<float>(hits_ground_ ? space.slant_depth.cos_apparent_sun(0.0, cosine) : cosine));
    ground_sun_.push_back(space.slant_depth.weights_towards(0.0, cosine));
  }
  for (const std::vector<LitPart>& parts : lit) {
    first_lit_.push_back(static_cast<int>(lit_.size()));
    lit_.insert(lit_.end(), parts.begin(), parts.end());
  }
  first_lit_.push_back(static_cast<int>(lit_.size()));
}

RayView Ray::view() const {
  return {.segments = segments(),
          .pairs = pairs(),
          .hits_ground = hits_ground_,
          .segment = segment_.data(),
          .lit = lit_.data(),
          .first_lit = first_lit_.data(),
          .aureole = aureole_.data(),
          .lit_end = lit_end_.data(),
          .ground_sun = ground_sun_.data(),
          .ground_sun_cosine = ground_sun_cosine_.data()};
}

}  // namespace skylut::transfer
