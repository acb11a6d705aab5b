#include "skylut/core/directions.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

std::vector<Direction> directions_utm271() {
  std::vector<Direction> directions{{0.0, 0.0}};
  for (int ring = 1; ring <= 9; ++ring)
    for (int step = 0; step < 30; ++step) directions.push_back({10.0 * ring, 12.0 * step});
  return directions;
}

std::vector<Direction> directions_preetham343() {
  constexpr int kRings = 19;
  constexpr int kAzimuths = 18;
  constexpr int kCount = 1 + kRings * kAzimuths;
  std::vector<Direction> directions{{0.0, 0.0}};
  for (int ring = 0; ring < kRings; ++ring) {
    // The zenith cap takes 1/343 of the hemisphere, every ring 18/343; its directions sit at the
    // ring's middle in cos θ.
    const double cos_zenith = 1.0 - (1.0 + kAzimuths * (ring + 0.5)) / kCount;
    for (int step = 0; step < kAzimuths; ++step)
      directions.push_back({std::acos(cos_zenith) * kDegreesPerRadian, 360.0 / kAzimuths * step});
  }
  return directions;
}

double angle_between(const Direction& a, const Direction& b) {
  const double zenith_a = a.zenith_deg * kRadiansPerDegree;
  const double zenith_b = b.zenith_deg * kRadiansPerDegree;
  const double half_zenith = std::sin(0.5 * (zenith_a - zenith_b));
  // Folded exactly, so that mirror images have equal angles to the last bit.
  const double turned_deg = std::remainder(a.azimuth_deg - b.azimuth_deg, 360.0);
  const double half_azimuth = std::sin(0.5 * turned_deg * kRadiansPerDegree);
  const double haversine =
      half_zenith * half_zenith + std::sin(zenith_a) * std::sin(zenith_b) * half_azimuth * half_azimuth;
  return 2.0 * std::asin(std::sqrt(std::clamp(haversine, 0.0, 1.0)));
}

double wrapped_azimuth_deg(double azimuth_deg) {
  double turned = std::fmod(azimuth_deg, 360.0);
  if (turned < 0.0) turned += 360.0;
  // -1e-20 + 360 rounds to 360; 0 is added so that -0 becomes 0.
  return turned < 360.0 ? turned + 0.0 : 0.0;
}

double folded_relative_azimuth_deg(double azimuth_deg, double sun_azimuth_deg) {
  const double turned = std::abs(std::remainder(azimuth_deg - sun_azimuth_deg, 360.0));
  return std::round(turned * 1e9) * 1e-9;
}

}  // namespace skylut
