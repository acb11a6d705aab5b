#include "ray_sources.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

RaySources::RaySources(const Discretisation& grid, Ray& ray, bool stokes)
    : azimuth_stride_(ray.azimuthal_orders()) {
  const RayTrace trace = grid.common.ray_space().trace(grid.ray_levels, ray.observer_km(), ray.cos_view());
  add_pieces(grid, trace.points);
  for (const RayPoint& point : source_at_) {
    for (int m = 0; m < grid.angles.azimuthal_orders(); ++m)
      for (const double value : normalised_legendre(m, grid.angles.resolution().max_l, -point.cos_view))
        polar_moment_.push_back(static_cast<float>(value));
    horizon_.push_back(grid.horizon.at(-point.cos_view, point.altitude_km));
    const LocalSun::Point& local = ray.suns_at(point);
    sun_weights_.push_back(local.sun_weights.data());
    azimuth_factor_.push_back(local.azimuth_factor.data());
    if (!stokes) continue;
    azimuth_sine_.push_back(local.azimuth_sine.data());
    grid.polarised->rotation_functions(-point.cos_view, rotation_r_, rotation_t_);
  }
}

void RaySources::add_pieces(const Discretisation& grid, const std::vector<RayPoint>& points) {
  const auto add_source = [&](int sublayer, const RayPoint& point) {
    const double lower_km = grid.sublayers.level_km(sublayer);
    const double thickness_km = grid.sublayers.level_km(sublayer + 1) - lower_km;
    const double fraction = std::clamp((point.altitude_km - lower_km) / thickness_km, 0.0, 1.0);
    source_.push_back({sublayer, static_cast<float>(fraction)});
    source_at_.push_back(point);
  };
  int sublayer = grid.sublayers.layer_of(points.front().altitude_km);
  for (std::size_t near = 0, far; near + 1 < points.size(); near = far) {
    for (far = near + 1; far + 1 < points.size() && !grid.needs_source_at(points[far].altitude_km);) ++far;
    sublayer = grid.sublayers.layer_of(0.5 * (points[near].altitude_km + points[near + 1].altitude_km));
    add_source(sublayer, points[near]);
    const double start_km = points[near].distance_km;
    const double length_km = points[far].distance_km - start_km;
    const auto fraction = [&](const RayPoint& point) {
      return static_cast<float>((point.distance_km - start_km) / length_km);
    };
    for (std::size_t i = near; i < far; ++i) {
      const double middle_km = 0.5 * (points[i].altitude_km + points[i + 1].altitude_km);
      piece_.push_back({grid.common.layers.layer_of(middle_km),
                        static_cast<float>(points[i + 1].distance_km - points[i].distance_km),
                        static_cast<int>(source_.size()) - 1, fraction(points[i]), fraction(points[i + 1])});
      sublayer = grid.sublayers.layer_of(middle_km);
    }
  }
  add_source(sublayer, points.back());
}

RaySourcesView RaySources::view() const {
  return {.pieces = static_cast<int>(piece_.size()),
          .sources = static_cast<int>(source_.size()),
          .azimuth_stride = azimuth_stride_,
          .piece = piece_.data(),
          .source = source_.data(),
          .polar_moment = polar_moment_.data(),
          .horizon = horizon_.data(),
          .sun_weights = sun_weights_.data(),
          .azimuth_factor = azimuth_factor_.data(),
          .azimuth_sine = azimuth_sine_.empty() ? nullptr : azimuth_sine_.data(),
          .rotation = {rotation_r_.data(), rotation_t_.data()}};
}

}  // namespace skylut::transfer
