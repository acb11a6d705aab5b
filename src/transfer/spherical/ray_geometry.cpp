#include "ray_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "interpolation.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

RayGeometry::RayGeometry(const Discretisation& grid, double observer_km, double view_zenith_deg,
                         std::span<const SunAzimuth> pairs) {
  const double cos_view = std::cos(view_zenith_deg * kRadiansPerDegree);
  const std::vector<RayPoint> points = trace(grid, observer_km, cos_view);
  add_segments(grid, points);
  add_pair_sources(grid, points, pairs);
  add_lit_parts(grid, points, pairs);
  for (const double level : grid.layers.levels_km()) level_altitude_km_.push_back(static_cast<float>(level));
}

/// Points where the ray crosses sublayer boundaries, with long steps split, from the observer to the top of
/// the atmosphere or to the ground.
std::vector<RayPoint> RayGeometry::trace(const Discretisation& grid, double observer_km, double cos_view) {
  const ShellGeometry& shells = grid.ray_steps;
  const double radius = shells.planet_radius_km() + observer_km;
  const double along = radius * cos_view;  // distance from the closest point, negative while descending
  // Distance between the closest point and altitude h; -1 if the ray does not reach down to it.
  const auto from_closest = [&](double h) {
    const double square = shells.radius_square_difference(h, observer_km) + along * along;
    return square >= 0.0 ? std::sqrt(square) : -1.0;
  };
  std::vector<RayPoint> crossings{{0.0, observer_km, cos_view}};
  const auto cross = [&](double level_km, double signed_distance) {
    const double distance = signed_distance - along;
    if (distance > 1e-9 * (1.0 + std::abs(along)))
      crossings.push_back({distance, level_km, signed_distance / (shells.planet_radius_km() + level_km)});
  };
  hits_ground_ = cos_view < 0.0 && from_closest(0.0) >= 0.0;
  if (cos_view < 0.0) {
    for (int level = shells.levels() - 1; level >= 0; --level)
      if (shells.level_km(level) < observer_km && from_closest(shells.level_km(level)) >= 0.0)
        cross(shells.level_km(level), -from_closest(shells.level_km(level)));
  }
  if (!hits_ground_) {
    const double perigee_distance = -along;
    if (cos_view < 0.0) {
      const double lowest_km =
          std::sqrt(std::max(0.0, radius * radius - along * along)) - shells.planet_radius_km();
      crossings.push_back({perigee_distance, lowest_km, 0.0});
    }
    for (int level = 0; level < shells.levels(); ++level)
      if ((cos_view < 0.0 || shells.level_km(level) > observer_km) &&
          from_closest(shells.level_km(level)) >= 0.0 &&
          from_closest(shells.level_km(level)) - along > crossings.back().distance_km)
        cross(shells.level_km(level), from_closest(shells.level_km(level)));
  }
  std::vector<RayPoint> points{crossings.front()};
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const RayPoint& from = crossings[i - 1];
    const RayPoint& to = crossings[i];
    const int parts =
        static_cast<int>(std::ceil((to.distance_km - from.distance_km) / grid.limits.ray_step_km));
    for (int part = 1; part < parts; ++part) {
      const double distance = from.distance_km + (to.distance_km - from.distance_km) * part / parts;
      const double signed_distance = distance + along;
      // h from r² = r₀² + d² + 2 d r₀ cos: the difference of squares keeps h accurate.
      const double gained = distance * (distance + 2.0 * along);
      const double altitude = observer_km + gained / (std::sqrt(radius * radius + gained) + radius);
      points.push_back({distance, altitude, signed_distance / (shells.planet_radius_km() + altitude)});
    }
    points.push_back(to);
  }
  return points;
}

void RayGeometry::add_segments(const Discretisation& grid, const std::vector<RayPoint>& points) {
  const ShellGeometry& shells = grid.sublayers;
  const AngularGrid& angles = grid.angles;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const RayPoint& near = points[i];
    const RayPoint& far = points[i + 1];
    const double middle_km = 0.5 * (near.altitude_km + far.altitude_km);
    const int sublayer = shells.layer_of(middle_km);
    const double lower = shells.level_km(sublayer);
    const double thickness = shells.level_km(sublayer + 1) - lower;
    const auto fraction = [&](double altitude) {
      return static_cast<float>(std::clamp((altitude - lower) / thickness, 0.0, 1.0));
    };
    const int layer = grid.layers.layer_of(middle_km);
    segment_.push_back({sublayer, layer, static_cast<float>(far.distance_km - near.distance_km),
                        fraction(near.altitude_km), fraction(far.altitude_km)});
    for (const RayPoint* end : {&near, &far})
      for (int m = 0; m < angles.azimuthal_orders(); ++m)
        for (const double value : normalised_legendre(m, angles.resolution().max_l, -end->cos_view))
          polar_moment_.push_back(static_cast<float>(value));
  }
}

void RayGeometry::add_pair_sources(const Discretisation& grid, const std::vector<RayPoint>& points,
                                   std::span<const SunAzimuth> pairs) {
  const double radius = grid.layers.planet_radius_km() + points.front().altitude_km;
  const double cos_view = points.front().cos_view;
  const double sin_view = std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view));
  const int orders = grid.angles.azimuthal_orders();
  std::vector<RaySource> at_point;
  std::vector<float> factor_at_point;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RayPoint& point = points[i];
    at_point.clear();
    factor_at_point.clear();
    for (const SunAzimuth& pair : pairs) {
      const double sun = pair.sun_zenith_deg * kRadiansPerDegree;
      const double azimuth = pair.relative_azimuth_deg * kRadiansPerDegree;
      const double view_to_sun = cos_view * std::cos(sun) + sin_view * std::sin(sun) * std::cos(azimuth);
      const double local_radius = grid.layers.planet_radius_km() + point.altitude_km;
      const double cos_sun =
          std::clamp((radius * std::cos(sun) + point.distance_km * view_to_sun) / local_radius, -1.0, 1.0);
      const Taps taps = cubic_taps(grid.sun_nodes_deg, std::acos(cos_sun) * kDegreesPerRadian);
      at_point.push_back({taps.first, {taps.weight[0], taps.weight[1], taps.weight[2], taps.weight[3]}});

      // Azimuth of the light (it travels against the view) from that of the sunbeam, which equals the
      // azimuth of the view from that of the sun.
      const double sines =
          std::sqrt(std::max(0.0, (1.0 - cos_sun * cos_sun) * (1.0 - point.cos_view * point.cos_view)));
      const double cosine = sines > 1e-12
                                ? std::clamp((view_to_sun - cos_sun * point.cos_view) / sines, -1.0, 1.0)
                                : std::cos(azimuth);
      double previous = 1.0;
      double current = cosine;
      factor_at_point.push_back(1.0f);
      for (int m = 1; m < orders; ++m) {
        factor_at_point.push_back(static_cast<float>(2.0 * current));
        const double next = 2.0 * cosine * current - previous;  // cos((m+1)φ)
        previous = current;
        current = next;
      }
    }
    // An inner point ends one segment and starts the next.
    const int copies = i == 0 || i + 1 == points.size() ? 1 : 2;
    for (int copy = 0; copy < copies; ++copy) {
      source_.insert(source_.end(), at_point.begin(), at_point.end());
      azimuth_factor_.insert(azimuth_factor_.end(), factor_at_point.begin(), factor_at_point.end());
    }
  }
}

void RayGeometry::add_lit_parts(const Discretisation& grid, const std::vector<RayPoint>& points,
                                std::span<const SunAzimuth> pairs) {
  const RayPoint& end = points.back();
  first_lit_.push_back(0);
  for (const SunAzimuth& pair : pairs) {
    const SunlitRay ray(grid.layers.planet_radius_km(), points.front(),
                        pair.sun_zenith_deg * kRadiansPerDegree,
                        pair.relative_azimuth_deg * kRadiansPerDegree);
    ray.append_parts(points, grid.limits.sunbeam_step_km, lit_);
    first_lit_.push_back(static_cast<int>(lit_.size()));
    cos_scattering_.push_back(ray.cos_scattering());
    ground_perigee_km_.push_back(static_cast<float>(ray.perigee_km(end.distance_km, 0.0)));
    ground_sun_cosine_.push_back(static_cast<float>(ray.cos_sun(end.distance_km, 0.0)));
  }
}

std::vector<float> RayGeometry::phases(const BlockOptics& optics) const {
  const auto stride = static_cast<std::size_t>(optics.scatterers * optics.lanes);
  std::vector<float> phase(stride * cos_scattering_.size());
  for (std::size_t pair = 0; pair < cos_scattering_.size(); ++pair)
    optics.phase_values(cos_scattering_[pair], phase.data() + pair * stride);
  return phase;
}

RayView RayGeometry::view(const Discretisation& grid) const {
  return {segments(),
          pairs(),
          hits_ground_,
          static_cast<float>(grid.layers.planet_radius_km()),
          segment_.data(),
          polar_moment_.data(),
          source_.data(),
          source_.data() + source_.size() - cos_scattering_.size(),
          azimuth_factor_.data(),
          lit_.data(),
          first_lit_.data(),
          level_altitude_km_.data(),
          ground_perigee_km_.data(),
          ground_sun_cosine_.data()};
}

}  // namespace skylut::transfer
