#include <algorithm>
#include <cmath>

#include "ray_trace.hpp"

namespace skylut::transfer {

BentLine::BentLine(const RefractiveShells& shells, double observer_km, double cos_view)
    : shells_(&shells), optical_observer_km_(shells.optical_km(observer_km)) {
  const ShellGeometry& optical = shells.optical();
  const double x = optical.planet_radius_km() + optical_observer_km_;
  start_along_km_ = x * cos_view;
  impact_km_ = std::sqrt(std::max(0.0, (x - start_along_km_) * (x + start_along_km_)));
  to_level_.resize(static_cast<std::size_t>(optical.levels()));
  for (int layer = 0; layer < optical.layers(); ++layer) {
    const double climb = optical.radius_square_difference(optical.level_km(layer + 1), optical_observer_km_);
    const double square = climb + start_along_km_ * start_along_km_;
    if (square > 0.0)
      to_level_[static_cast<std::size_t>(layer) + 1] = way_to(optical.level_km(layer + 1), std::sqrt(square));
  }
  start_ = way_to(optical_observer_km_, start_along_km_);
}

BentLine::Way BentLine::way_to(double optical_km, double along_km) const {
  const ShellGeometry& optical = shells_->optical();
  int layer = optical.layer_of(optical_km);
  // A level ends the layer below it: its way is known only after that layer's.
  if (layer > 0 && optical_km <= optical.level_km(layer)) --layer;
  const double w = std::abs(along_km);
  const double lower_square = optical.radius_square_difference(optical.level_km(layer), optical_km) + w * w;
  const double lower = std::sqrt(std::max(0.0, lower_square));
  const Way before = to_level_[static_cast<std::size_t>(layer)];
  // (x/r) dr/dx = 1 + (x_k dr/dx - r_k)/r along the straight x(r) from level k.
  const double bottom_km = shells_->layers().level_km(layer);
  const double planet_km = shells_->layers().planet_radius_km();
  const double middle_km = 0.5 * (bottom_km + shells_->altitude_km(optical_km));
  const double excess = (optical.planet_radius_km() + optical.level_km(layer)) * shells_->stretch(layer) -
                        (planet_km + bottom_km);
  const double turns = 1.0 + excess / (planet_km + middle_km);
  return {before.length_km + shells_->stretch(layer) * (w - lower),
          before.turned_rad + turns * (std::atan2(w, impact_km_) - std::atan2(lower, impact_km_))};
}

double BentLine::along_km(const RayPoint& point) const {
  return point.cos_view * (shells_->optical().planet_radius_km() + shells_->optical_km(point.altitude_km));
}

RayPoint BentLine::at(double along_km) const {
  const ShellGeometry& optical = shells_->optical();
  // x² - x0² = w² - w0²: the difference keeps the altitude accurate.
  const double gained = (along_km - start_along_km_) * (along_km + start_along_km_);
  const double x0 = optical.planet_radius_km() + optical_observer_km_;
  const double x = std::sqrt(x0 * x0 + gained);
  const double optical_km = std::clamp(optical_observer_km_ + gained / (x + x0), 0.0, optical.top_km());
  const Way way = way_to(optical_km, along_km);
  const double sign = along_km < 0.0 ? -1.0 : 1.0;
  const double start_sign = start_along_km_ < 0.0 ? -1.0 : 1.0;
  return {sign * way.length_km - start_sign * start_.length_km, shells_->altitude_km(optical_km),
          along_km / x, sign * way.turned_rad - start_sign * start_.turned_rad};
}

RayTrace::RayTrace(const RefractiveShells& air, const ShellGeometry& levels, double longest_step_km,
                   double observer_km, double cos_view) {
  const ShellGeometry optical = air.optical(levels);
  const double observer_optical_km = air.optical_km(observer_km);
  const RayTrace straight(optical, longest_step_km, observer_optical_km, cos_view);
  const BentLine line(air, observer_km, cos_view);
  const double start = (optical.planet_radius_km() + observer_optical_km) * cos_view;
  hits_ground = straight.hits_ground;
  for (const RayPoint& point : straight.points) {
    RayPoint bent = line.at(start + point.distance_km);
    bent.cos_view = point.cos_view;
    // Levels and observer to the last bit.
    const auto level =
        std::lower_bound(optical.levels_km().begin(), optical.levels_km().end(), point.altitude_km);
    if (level != optical.levels_km().end() && *level == point.altitude_km)
      bent.altitude_km = levels.level_km(static_cast<int>(level - optical.levels_km().begin()));
    if (points.empty()) {
      bent.altitude_km = observer_km;
      bent.distance_km = 0.0;
      bent.turned_rad = 0.0;
    }
    points.push_back(bent);
  }
}

}  // namespace skylut::transfer
