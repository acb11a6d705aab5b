#include "skylut/forms/dome_views.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

constexpr int kFittingSpiral = 240;

/// A ring around the sun, and the annulus for which it stands.
struct Ring {
  double radius_deg;
  double from_deg;
  double to_deg;
};

constexpr int kRingViews = 12;

// The direction at an angle from the sun, seen under another from the arc to the zenith.
Direction around(const Direction& sun, double radius_deg, double position_deg) {
  const double sun_rad = sun.zenith_deg * kRadiansPerDegree;
  const double radius = radius_deg * kRadiansPerDegree;
  const double position = position_deg * kRadiansPerDegree;
  const double cos_zenith =
      std::cos(sun_rad) * std::cos(radius) + std::sin(sun_rad) * std::sin(radius) * std::cos(position);
  const double azimuth = std::atan2(
      std::sin(radius) * std::sin(position),
      std::cos(radius) * std::sin(sun_rad) - std::sin(radius) * std::cos(sun_rad) * std::cos(position));
  return {std::acos(std::clamp(cos_zenith, -1.0, 1.0)) * kDegreesPerRadian,
          wrapped_azimuth_deg(sun.azimuth_deg + azimuth * kDegreesPerRadian)};
}

DomeViews dome(const Direction& sun, int spiral, double turn_deg, std::span<const Ring> rings) {
  constexpr double kGoldenAngle_deg = 137.50776405003785;
  DomeViews dome;
  const double share = 2.0 * kPi / spiral;
  // It shares the solid angle of the spiral's first point.
  dome.views.push_back({0.0, 0.0});
  dome.solid_angle.push_back(0.5 * share);
  const double inner_rad = rings.back().to_deg * kRadiansPerDegree;
  for (int i = 0; i < spiral; ++i) {
    const double cos_zenith = 1.0 - (i + 0.5) / spiral;
    // The sky has a mirror plane: one half of it, seen twice as densely.
    const double turn = std::fmod(turn_deg + i * kGoldenAngle_deg, 360.0);
    const Direction view{std::acos(cos_zenith) * kDegreesPerRadian,
                         wrapped_azimuth_deg(sun.azimuth_deg + (turn > 180.0 ? 360.0 - turn : turn))};
    if (angle_between(view, sun) < inner_rad) continue;
    dome.views.push_back(view);
    dome.solid_angle.push_back(i == 0 ? 0.5 * share : share);
  }
  for (const Ring& ring : rings) {
    const double annulus =
        2.0 * kPi * (std::cos(ring.from_deg * kRadiansPerDegree) - std::cos(ring.to_deg * kRadiansPerDegree));
    for (int k = 0; k < kRingViews; ++k) {
      const Direction view = around(sun, ring.radius_deg, (k + 0.5) * 180.0 / kRingViews);
      if (view.zenith_deg > 90.0) continue;
      dome.views.push_back(view);
      dome.solid_angle.push_back(annulus / kRingViews);
    }
  }
  return dome;
}

}  // namespace

double fit_weight(const DomeViews& dome, std::size_t view) {
  constexpr double kLeast_sr = 0.1 * 2.0 * kPi / kFittingSpiral;
  return std::max(dome.solid_angle[view], kLeast_sr);
}

DomeViews fitting_views(const Direction& sun) {
  constexpr Ring kRings[] = {{0.75, 0.3, 1.1}, {1.5, 1.1, 2.2}, {3.0, 2.2, 3.75}, {4.75, 3.75, 6.0}};
  return dome(sun, kFittingSpiral, 0.0, kRings);
}

DomeViews checking_views(const Direction& sun) {
  constexpr Ring kRings[] = {
      {0.5, 0.3, 0.75}, {1.0, 0.75, 1.5}, {2.0, 1.5, 2.75}, {3.5, 2.75, 4.25}, {5.0, 4.25, 6.0}};
  return dome(sun, 577, 71.0, kRings);
}

}  // namespace skylut
