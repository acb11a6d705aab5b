#include "local_sun.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

namespace {

/// Below, an azimuth from rounded cosines means nothing: of the view, whose cosine is its local one, and of
/// view and sun multiplied.
constexpr double kLeastViewSine = 1e-7;
constexpr double kLeastSines = 1e-12;

}  // namespace

LocalSun::LocalSun(double planet_radius_km, const RayPoint& start, bool bends,
                   std::span<const SunAzimuth> pairs, const CubicInterpolation& suns, int azimuthal_orders)
    : planet_km_(planet_radius_km), bends_(bends), suns_(&suns), azimuthal_orders_(azimuthal_orders) {
  const double sin_view = std::sqrt(std::max(0.0, 1.0 - start.cos_view * start.cos_view));
  for (const SunAzimuth& pair : pairs) {
    const double sun = pair.sun_zenith_deg * kRadiansPerDegree;
    const double cos_azimuth = std::cos(pair.relative_azimuth_deg * kRadiansPerDegree);
    pairs_.push_back({(planet_km_ + start.altitude_km) * std::cos(sun),
                      start.cos_view * std::cos(sun) + sin_view * std::sin(sun) * cos_azimuth, cos_azimuth,
                      std::cos(sun), std::sin(sun) * cos_azimuth});
  }
}

const LocalSun::Point& LocalSun::at(const RayPoint& point) {
  const auto [found, is_new] = known_.try_emplace(point.distance_km);
  if (is_new) found->second = locate(point);
  return found->second;
}

LocalSun::Cosines LocalSun::cosines_at(const RayPoint& point, const AtStart& pair) const {
  if (!bends_) {
    const double inverse_radius = 1.0 / (planet_km_ + point.altitude_km);
    return {(pair.along_sun_km + point.distance_km * pair.cos_scattering) * inverse_radius,
            pair.cos_scattering};
  }
  // In the plane of the line its vertical has turned by φ, its direction by φ + ψ.
  const double turned = point.turned_rad;
  const double direction = turned + std::acos(std::clamp(point.cos_view, -1.0, 1.0));
  return {std::cos(turned) * pair.cos_sun + std::sin(turned) * pair.sun_towards_view,
          std::cos(direction) * pair.cos_sun + std::sin(direction) * pair.sun_towards_view};
}

LocalSun::Point LocalSun::locate(const RayPoint& point) const {
  Point local;
  local.sun_weights.reserve(pairs_.size());
  local.azimuth_factor.resize(pairs_.size() * static_cast<std::size_t>(azimuthal_orders_));
  local.azimuth_sine.resize(local.azimuth_factor.size());
  float* factor = local.azimuth_factor.data();
  float* sine = local.azimuth_sine.data();
  const double local_sin_view = std::sqrt(std::max(0.0, 1.0 - point.cos_view * point.cos_view));
  for (const AtStart& pair : pairs_) {
    const Cosines local_cosines = cosines_at(point, pair);
    const double cos_sun = std::clamp(local_cosines.sun, -1.0, 1.0);
    local.sun_weights.push_back((*suns_)(std::acos(cos_sun) * kDegreesPerRadian));

    // Azimuth of the light (it travels against the view) from that of the sunbeam, which equals the
    // azimuth of the view from that of the sun.
    const double sines = std::sqrt(1.0 - cos_sun * cos_sun) * local_sin_view;
    // A vertical ray keeps the azimuth that was asked for: its own, from rounded cosines, would be any, and Q
    // counts from it.
    const double cosine =
        sines > kLeastSines && local_sin_view > kLeastViewSine
            ? std::clamp((local_cosines.scattering - cos_sun * point.cos_view) / sines, -1.0, 1.0)
            : pair.cos_azimuth;
    double previous = 1.0;
    double current = cosine;
    double previous_sine = 0.0;
    double current_sine = std::sqrt(1.0 - cosine * cosine);
    *factor++ = 1.0f;
    *sine++ = 0.0f;
    for (int m = 1; m < azimuthal_orders_; ++m) {
      *factor++ = static_cast<float>(2.0 * current);
      *sine++ = static_cast<float>(2.0 * current_sine);
      const double next = 2.0 * cosine * current - previous;  // cos((m+1)φ)
      previous = current;
      current = next;
      const double next_sine = 2.0 * cosine * current_sine - previous_sine;
      previous_sine = current_sine;
      current_sine = next_sine;
    }
  }
  return local;
}

}  // namespace skylut::transfer
