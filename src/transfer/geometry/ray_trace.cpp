#include "ray_trace.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/check.hpp"

namespace skylut::transfer {

RayTrace::RayTrace(const ShellGeometry& levels, double longest_step_km, double observer_km, double cos_view) {
  const double radius = levels.planet_radius_km() + observer_km;
  const double along = radius * cos_view;  // distance from the closest point, negative while descending
  // Distance between the closest point and altitude h; -1 if the ray does not reach down to it.
  const auto from_closest = [&](double h) {
    const double square = levels.radius_square_difference(h, observer_km) + along * along;
    return square >= 0.0 ? std::sqrt(square) : -1.0;
  };
  std::vector<RayPoint> crossings{{0.0, observer_km, cos_view}};
  const auto cross = [&](double level_km, double signed_distance) {
    const double distance = signed_distance - along;
    if (distance > 1e-9 * (1.0 + std::abs(along)))
      crossings.push_back({distance, level_km, signed_distance / (levels.planet_radius_km() + level_km)});
  };
  hits_ground = cos_view < 0.0 && from_closest(0.0) >= 0.0;
  if (cos_view < 0.0) {
    for (int level = levels.levels() - 1; level >= 0; --level)
      if (levels.level_km(level) < observer_km && from_closest(levels.level_km(level)) >= 0.0)
        cross(levels.level_km(level), -from_closest(levels.level_km(level)));
  }
  if (!hits_ground) {
    const double perigee_distance = -along;
    if (cos_view < 0.0) {
      const double lowest_km =
          std::sqrt(std::max(0.0, radius * radius - along * along)) - levels.planet_radius_km();
      // A line that touches a level, to the last bit, has its lowest point there already.
      if (perigee_distance > crossings.back().distance_km)
        crossings.push_back({perigee_distance, lowest_km, 0.0});
    }
    for (int level = 0; level < levels.levels(); ++level)
      if ((cos_view < 0.0 || levels.level_km(level) > observer_km) &&
          from_closest(levels.level_km(level)) >= 0.0 &&
          from_closest(levels.level_km(level)) - along > crossings.back().distance_km)
        cross(levels.level_km(level), from_closest(levels.level_km(level)));
  }
  points.push_back(crossings.front());
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const RayPoint& from = crossings[i - 1];
    const RayPoint& to = crossings[i];
    SKYLUT_CHECK_LE(from.distance_km, to.distance_km);
    const int parts = static_cast<int>(std::ceil((to.distance_km - from.distance_km) / longest_step_km));
    for (int part = 1; part < parts; ++part) {
      const double distance = from.distance_km + (to.distance_km - from.distance_km) * part / parts;
      const double signed_distance = distance + along;
      // h from r² = r₀² + d² + 2 d r₀ cos: the difference of squares keeps h accurate.
      const double gained = distance * (distance + 2.0 * along);
      const double altitude = observer_km + gained / (std::sqrt(radius * radius + gained) + radius);
      points.push_back({distance, altitude, signed_distance / (levels.planet_radius_km() + altitude)});
    }
    points.push_back(to);
  }
}

}  // namespace skylut::transfer
