#include "ray_geometry.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "sunlit_ray.hpp"

namespace skylut::transfer {

RayGeometry::RayGeometry(const CommonGrid& common, double observer_km, double view_zenith_deg,
                         std::span<const SunAzimuth> pairs) {
  const RayTrace trace(common.layers, common.discretisation.ray_step_km, observer_km,
                       std::cos(view_zenith_deg * kRadiansPerDegree));
  start_ = trace.points.front();
  hits_ground_ = trace.hits_ground;
  for (std::size_t i = 0; i + 1 < trace.points.size(); ++i) {
    const RayPoint& near = trace.points[i];
    const RayPoint& far = trace.points[i + 1];
    segment_.push_back({common.layers.layer_of(0.5 * (near.altitude_km + far.altitude_km)),
                        static_cast<float>(far.distance_km - near.distance_km)});
  }
  const RayPoint& end = trace.points.back();
  std::vector<std::vector<LitPart>> lit(segment_.size());
  int aureoles = 0;
  for (const SunAzimuth& pair : pairs) {
    const SunlitRay ray(common.slant_depth, common.shells.planet_radius_km, trace.points.front(),
                        pair.sun_zenith_deg * kRadiansPerDegree,
                        pair.relative_azimuth_deg * kRadiansPerDegree);
    ray.append_parts(trace.points, common.discretisation.sunbeam_step_km,
                     static_cast<int>(cos_scattering_.size()), lit, lit_end_);
    cos_scattering_.push_back(ray.cos_scattering());
    aureole_.push_back(aureole_weight(ray.cos_scattering()) > 0.0 ? aureoles++ : -1);
    const double cosine = hits_ground_ ? ray.cos_sun(end.distance_km, 0.0) : -1.0;
    ground_sun_cosine_.push_back(static_cast<float>(cosine));
    ground_sun_.push_back(common.slant_depth.weights_towards(0.0, cosine));
  }
  for (const std::vector<LitPart>& parts : lit) {
    first_lit_.push_back(static_cast<int>(lit_.size()));
    lit_.insert(lit_.end(), parts.begin(), parts.end());
  }
  first_lit_.push_back(static_cast<int>(lit_.size()));
}

std::vector<float> RayGeometry::phases(const BlockOptics& optics) const {
  const auto stride = static_cast<std::size_t>(optics.scatterers * optics.lanes);
  std::vector<float> phase(stride * cos_scattering_.size());
  for (std::size_t pair = 0; pair < cos_scattering_.size(); ++pair)
    optics.phase_values(cos_scattering_[pair], phase.data() + pair * stride);
  return phase;
}

std::vector<float> RayGeometry::peaks(const BlockOptics& optics) const {
  const auto stride = static_cast<std::size_t>(2 * optics.scatterers * optics.lanes);
  std::vector<float> peak;
  for (std::size_t pair = 0; pair < cos_scattering_.size(); ++pair) {
    if (aureole_[pair] < 0) continue;
    peak.resize(peak.size() + stride);
    optics.peak_values(cos_scattering_[pair], peak.data() + peak.size() - stride);
    if (const double weight = aureole_weight(cos_scattering_[pair]); weight < 1.0)
      for (std::size_t i = peak.size() - stride; i < peak.size(); ++i) peak[i] *= static_cast<float>(weight);
  }
  return peak;
}

RayView RayGeometry::view() const {
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
