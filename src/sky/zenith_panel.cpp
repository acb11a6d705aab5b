#include "zenith_panel.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

/// Where panels above the horizontal end. A sky changes with the air mass, on the scale of √(2H/R), 3° for
/// air and 0.5° for the lowest layer.
constexpr double kElevations_deg[] = {0.0, 0.35, 1.5, 5.0, 15.0, 40.0, 90.0};
/// A hair from the horizon on either side, so that rounding takes no line across it.
constexpr double kHairAbove_km = 1e-6;
constexpr double kHairBelow_deg = 1e-3;

/// The same where lines meet the ground, seen from aloft.
constexpr double kGroundElevations_deg[] = {kHairBelow_deg, 0.3, 1.5, 6.0, 25.0, 90.0};
/// Layers thinner than this are taken together in the limb, km: their kinks are too.
constexpr double kThinnest_km = 0.2;

/// Of the dome's coordinate: between the scales of air and of its lowest layer.
constexpr double kDomeScale_deg = 1.5;

double dome_coordinate(double elevation_deg) { return std::log1p(elevation_deg / kDomeScale_deg); }

double clamped_sine(double sine) { return std::clamp(sine, -1.0, 1.0); }

}  // namespace

ZenithPanel::ZenithPanel(Kind kind, double from, double to, double observer_km, double planet_radius_km)
    : kind_(kind), first_(from), last_(to), observer_km_(observer_km), planet_km_(planet_radius_km) {
  if (kind == Kind::limb) {
    top_km_ = from;
    bottom_km_ = to;
    first_ = 0.0;
    last_ = 1.0;
  }
  if (kind == Kind::dome) {
    first_ = dome_coordinate(from);
    last_ = dome_coordinate(to);
  }
  set_range();
}

ZenithPanel ZenithPanel::whole_dome(double observer_km, double planet_radius_km) {
  return {Kind::dome, 0.0, 90.0, observer_km, planet_radius_km};
}

ZenithPanel ZenithPanel::whole_limb(double observer_km, double planet_radius_km) {
  return {Kind::limb, observer_km, std::min(kHairAbove_km, 0.5 * observer_km), observer_km, planet_radius_km};
}

void ZenithPanel::set_range() {
  const double a = zenith_deg(-1.0);
  const double b = zenith_deg(1.0);
  lowest_ = std::min(a, b);
  highest_ = std::max(a, b);
}

double ZenithPanel::zenith_deg(double x) const {
  const double natural = first_ + 0.5 * (x + 1.0) * (last_ - first_);
  if (kind_ == Kind::above) return 90.0 - natural;
  if (kind_ == Kind::dome) return std::max(0.0, 90.0 - kDomeScale_deg * std::expm1(natural));
  if (kind_ == Kind::ground) {
    const double sine = planet_km_ * std::cos(natural * kRadiansPerDegree) / (planet_km_ + observer_km_);
    return 180.0 - std::asin(clamped_sine(sine)) * kDegreesPerRadian;
  }
  // The dip of a line that sinks by d = h - p: cos² = d (2R + h + p)/(R + h)².
  const double lowest_km = top_km_ - natural * natural * (top_km_ - bottom_km_);
  const double radius = planet_km_ + observer_km_;
  const double square = (observer_km_ - lowest_km) * (2.0 * planet_km_ + observer_km_ + lowest_km);
  return 90.0 + std::asin(clamped_sine(std::sqrt(std::max(0.0, square)) / radius)) * kDegreesPerRadian;
}

double ZenithPanel::natural_of(double zenith_deg) const {
  if (kind_ == Kind::above) return 90.0 - zenith_deg;
  if (kind_ == Kind::dome) return dome_coordinate(std::max(0.0, 90.0 - zenith_deg));
  const double radius = planet_km_ + observer_km_;
  const double dip = (zenith_deg - 90.0) * kRadiansPerDegree;
  if (kind_ == Kind::ground) {
    const double cosine = radius * std::cos(dip) / planet_km_;
    return std::acos(std::clamp(cosine, 0.0, 1.0)) * kDegreesPerRadian;
  }
  // h - p = (R + h)(1 - cos dip), without cancellation.
  const double half = std::sin(0.5 * dip);
  const double sunk_km = 2.0 * radius * half * half - (observer_km_ - top_km_);
  return std::sqrt(std::clamp(sunk_km / (top_km_ - bottom_km_), 0.0, 1.0));
}

double ZenithPanel::coordinate(double zenith_deg) const {
  return std::clamp(2.0 * (natural_of(zenith_deg) - first_) / (last_ - first_) - 1.0, -1.0, 1.0);
}

std::vector<ZenithPanel> ZenithPanel::halves() const {
  std::vector<ZenithPanel> both{*this, *this};
  const double middle = 0.5 * (first_ + last_);
  both[0].last_ = middle;
  both[1].first_ = middle;
  for (ZenithPanel& half : both) half.set_range();
  return both;
}

std::vector<ZenithPanel> zenith_panels(std::span<const double> levels_km, double observer_km,
                                       double planet_radius_km) {
  std::vector<ZenithPanel> panels;
  const auto add = [&](ZenithPanel::Kind kind, double from, double to) {
    panels.emplace_back(kind, from, to, observer_km, planet_radius_km);
  };
  for (std::size_t i = 0; i + 1 < std::size(kElevations_deg); ++i)
    add(ZenithPanel::Kind::above, kElevations_deg[i], kElevations_deg[i + 1]);
  if (observer_km > 0.0) {
    double top_km = observer_km;
    for (auto level = levels_km.rbegin(); level != levels_km.rend(); ++level) {
      if (*level >= top_km || (*level > 0.0 && top_km - *level < kThinnest_km)) continue;
      add(ZenithPanel::Kind::limb, top_km, std::max(*level, kHairAbove_km));
      top_km = *level;
    }
    for (std::size_t i = 0; i + 1 < std::size(kGroundElevations_deg); ++i)
      add(ZenithPanel::Kind::ground, kGroundElevations_deg[i], kGroundElevations_deg[i + 1]);
  } else {
    add(ZenithPanel::Kind::ground, kHairBelow_deg, 90.0);
  }
  std::sort(panels.begin(), panels.end(), [](const ZenithPanel& a, const ZenithPanel& b) {
    return a.lowest_zenith_deg() < b.lowest_zenith_deg();
  });
  return panels;
}

std::vector<double> lobatto_points(int count) {
  std::vector<double> points;
  for (int j = 0; j < count; ++j) points.push_back(-std::cos(kPi * j / (count - 1)));
  return points;
}

void lobatto_weights(double x, std::span<const double> points, std::span<double> weights) {
  double sum = 0.0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double distance = x - points[j];
    if (std::abs(distance) < 1e-12) {
      std::fill(weights.begin(), weights.end(), 0.0);
      weights[j] = 1.0;
      return;
    }
    const bool end = j == 0 || j + 1 == points.size();
    weights[j] = (j % 2 == 0 ? 1.0 : -1.0) * (end ? 0.5 : 1.0) / distance;
    sum += weights[j];
  }
  for (double& weight : weights) weight /= sum;
}

}  // namespace skylut
