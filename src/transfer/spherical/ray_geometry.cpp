#include "ray_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "interpolation.hpp"
#include "skylut/core/constants.hpp"

namespace skylut::transfer {

namespace {

/// Where the sunbeam's lowest altitude lies within this of the ground, its optical depth changes fast.
constexpr double kGrazing_km = 60.0;

/// Sun's direction seen from a point of the ray. The ray starts at (0, 0, r₀), runs in the direction V; the
/// sun is in the direction S.
struct SunAngles {
  double cos_sun;     ///< cosine of the local solar zenith angle
  double perigee_km;  ///< altitude of the sunbeam's line where it is closest to the centre
};

}  // namespace

RayGeometry::RayGeometry(const Discretisation& grid, double observer_km, double view_zenith_deg,
                         std::span<const SunAzimuth> pairs) {
  const double cos_view = std::cos(view_zenith_deg * kRadiansPerDegree);
  const std::vector<Point> points = trace(grid, observer_km, cos_view);
  add_segments(grid, points);
  add_pair_sources(grid, points, pairs);
  first_lit_.push_back(0);
  for (const SunAzimuth& pair : pairs) {
    add_lit_parts(grid, points, observer_km, cos_view, pair);
    first_lit_.push_back(static_cast<int>(lit_.size()));
  }
  for (const double level : grid.layers.levels_km()) level_altitude_km_.push_back(static_cast<float>(level));
}

/// Points where the ray crosses sublayer boundaries, with long steps split, from the observer to the top of
/// the atmosphere or to the ground.
std::vector<RayGeometry::Point> RayGeometry::trace(const Discretisation& grid, double observer_km,
                                                   double cos_view) {
  const ShellGeometry& shells = grid.sublayers;
  const double radius = shells.planet_radius_km() + observer_km;
  const double along = radius * cos_view;  // distance from the closest point, negative while descending
  // Distance between the closest point and altitude h; -1 if the ray does not reach down to it.
  const auto from_closest = [&](double h) {
    const double square = shells.radius_square_difference(h, observer_km) + along * along;
    return square >= 0.0 ? std::sqrt(square) : -1.0;
  };
  std::vector<Point> crossings{{0.0, observer_km, cos_view}};
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
  std::vector<Point> points{crossings.front()};
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const Point& from = crossings[i - 1];
    const Point& to = crossings[i];
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

void RayGeometry::add_segments(const Discretisation& grid, const std::vector<Point>& points) {
  const ShellGeometry& shells = grid.sublayers;
  const AngularGrid& angles = grid.angles;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point& near = points[i];
    const Point& far = points[i + 1];
    const int sublayer = shells.layer_of(0.5 * (near.altitude_km + far.altitude_km));
    const double lower = shells.level_km(sublayer);
    const double thickness = shells.level_km(sublayer + 1) - lower;
    const auto fraction = [&](double altitude) {
      return static_cast<float>(std::clamp((altitude - lower) / thickness, 0.0, 1.0));
    };
    segment_.push_back({sublayer, static_cast<float>(far.distance_km - near.distance_km),
                        fraction(near.altitude_km), fraction(far.altitude_km)});
    for (const Point* end : {&near, &far})
      for (int m = 0; m < angles.azimuthal_orders(); ++m)
        for (const double value : normalised_legendre(m, angles.resolution().max_l, -end->cos_view))
          polar_moment_.push_back(static_cast<float>(value));
  }
}

void RayGeometry::add_pair_sources(const Discretisation& grid, const std::vector<Point>& points,
                                   std::span<const SunAzimuth> pairs) {
  const double radius = grid.layers.planet_radius_km() + points.front().altitude_km;
  const double cos_view = points.front().cos_view;
  const double sin_view = std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view));
  const int orders = grid.angles.azimuthal_orders();
  std::vector<RaySource> at_point;
  std::vector<float> factor_at_point;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& point = points[i];
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

void RayGeometry::add_lit_parts(const Discretisation& grid, const std::vector<Point>& points,
                                double observer_km, double cos_view, const SunAzimuth& pair) {
  const double planet = grid.layers.planet_radius_km();
  const double radius = planet + observer_km;
  const double sun = pair.sun_zenith_deg * kRadiansPerDegree;
  const double sin_view = std::sqrt(std::max(0.0, 1.0 - cos_view * cos_view));
  const double view_to_sun =
      cos_view * std::cos(sun) +
      sin_view * std::sin(sun) * std::cos(pair.relative_azimuth_deg * kRadiansPerDegree);
  cos_scattering_.push_back(view_to_sun);  // light travels along -V, the beam along -S

  const auto sun_height = [&](double distance) {
    return radius * std::cos(sun) + distance * view_to_sun;
  };  // X·S
  const auto sun_angles = [&](double distance, double altitude) {
    const double local = planet + altitude;
    const double height = sun_height(distance);
    const double across = std::sqrt(std::max(0.0, local * local - height * height));
    // p - R without cancellation: (p² - R²)/(p + R), p² - R² = h(2R+h) - height².
    const double perigee = (altitude * (2.0 * planet + altitude) - height * height) / (across + planet);
    return SunAngles{height / local, std::min(perigee, altitude)};
  };
  const auto altitude_at = [&](double distance) {
    const double gained = distance * (distance + 2.0 * radius * cos_view);
    return observer_km + gained / (std::sqrt(radius * radius + gained) + radius);
  };
  // Shadow: X·S < 0 and |X|² - (X·S)² < R². Its boundary on the ray: a d² + 2 b d + c = 0.
  const double a = 1.0 - view_to_sun * view_to_sun;
  const double b = radius * (cos_view - std::cos(sun) * view_to_sun);
  const double c =
      observer_km * (2.0 * planet + observer_km) - radius * radius * std::cos(sun) * std::cos(sun);
  std::vector<double> edges;
  const double discriminant = b * b - a * c;
  if (a > 1e-14 && discriminant > 0.0)
    edges = {(-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a};
  const auto lit = [&](double distance) {
    return sun_height(distance) >= 0.0 || a * distance * distance + 2.0 * b * distance + c >= 0.0;
  };

  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    std::vector<double> cut{points[i].distance_km};
    const auto cut_at = [&](double end) {
      const double start = cut.back();
      const double near_perigee = sun_angles(start, altitude_at(start)).perigee_km;
      const double far_perigee = sun_angles(end, altitude_at(end)).perigee_km;
      const bool grazing = std::max(near_perigee, far_perigee) > -kGrazing_km &&
                           std::min(near_perigee, far_perigee) < kGrazing_km;
      const double pieces =
          grazing ? std::ceil(std::abs(far_perigee - near_perigee) / grid.limits.sunbeam_step_km) : 1.0;
      for (double piece = 1.0; piece < pieces; ++piece) cut.push_back(start + (end - start) * piece / pieces);
      cut.push_back(end);
    };
    for (const double edge : edges)
      if (edge > points[i].distance_km && edge < points[i + 1].distance_km && sun_height(edge) < 0.0)
        cut_at(edge);
    cut_at(points[i + 1].distance_km);
    for (std::size_t part = 0; part + 1 < cut.size(); ++part) {
      if (!lit(0.5 * (cut[part] + cut[part + 1]))) continue;
      const double near_km = part == 0 ? points[i].altitude_km : altitude_at(cut[part]);
      const double far_km = part + 2 == cut.size() ? points[i + 1].altitude_km : altitude_at(cut[part + 1]);
      const SunAngles near = sun_angles(cut[part], near_km);
      const SunAngles far = sun_angles(cut[part + 1], far_km);
      lit_.push_back({static_cast<int>(i), static_cast<float>(cut[part + 1] - cut[part]),
                      static_cast<float>(cut[part] - points[i].distance_km), static_cast<float>(near_km),
                      static_cast<float>(far_km), static_cast<float>(near.perigee_km),
                      static_cast<float>(far.perigee_km), near.cos_sun < 0.0, far.cos_sun < 0.0});
    }
  }
  LitPart ground{};
  double ground_cosine = 0.0;
  if (hits_ground_) {
    const SunAngles end = sun_angles(points.back().distance_km, 0.0);
    ground_cosine = end.cos_sun;
    ground.near_perigee_km = static_cast<float>(end.perigee_km);
  }
  ground_beam_.push_back(ground);
  ground_sun_cosine_.push_back(static_cast<float>(ground_cosine));
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
          ground_beam_.data(),
          ground_sun_cosine_.data()};
}

}  // namespace skylut::transfer
