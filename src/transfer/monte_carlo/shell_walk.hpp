#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut::monte_carlo {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector along(const Vector& start, const Vector& direction, double distance) {
  return {start[0] + distance * direction[0], start[1] + distance * direction[1],
          start[2] + distance * direction[2]};
}
Vector normalised(const Vector& v);

/// Turns a unit vector by the angle whose cosine is given, about a random azimuth (radians).
Vector turned(const Vector& direction, double cos_angle, double azimuth);

/// A point of a photon's path and the layer it lies in (on a boundary: the layer that it is about to enter).
struct PhotonPosition {
  Vector position{};      ///< km from the planet's centre
  std::size_t layer = 0;  ///< index from the ground
};

enum class WalkEnd { stopped, ground, top };

/// The shells, as straight rays meet them.
class ShellWalk {
 public:
  ShellWalk(const Shells& shells, const OpticalColumn& column);

  double extinction_per_km(std::size_t layer) const { return extinction_[layer]; }
  double ground_radius_km() const { return radius_.front(); }
  double level_radius_km(std::size_t level) const { return radius_[level]; }
  std::size_t layers() const { return extinction_.size(); }

  /// Follows a ray through the layers. `visit(layer, start_km, length_km)` is called for each piece in turn,
  /// start_km from the ray's origin, and returns false to stop.
  template <typename Visit>
  WalkEnd walk(const PhotonPosition& from, const Vector& direction, const Visit& visit) const;

  /// Optical depth to the top of the atmosphere; infinite if the ground is in the way.
  double depth_to_top(const PhotonPosition& from, const Vector& direction) const;

 private:
  std::vector<double> radius_;      ///< km, of the levels
  std::vector<double> extinction_;  ///< 1/km, of the layers
};

template <typename Visit>
WalkEnd ShellWalk::walk(const PhotonPosition& from, const Vector& direction, const Visit& visit) const {
  // r²(s) = p² + (s + b)², b = x·Ω, p the ray's closest approach to the centre; the ray meets radius R at
  // s = -b ± √(R² - p²).
  const double b = dot(from.position, direction);
  const double closest_squared = dot(from.position, from.position) - b * b;
  std::size_t layer = from.layer;
  double at = 0.0;
  if (b < 0.0) {
    while (true) {
      const double reach = radius_[layer] * radius_[layer] - closest_squared;
      if (reach <= 0.0) break;  // passes its closest point within this layer
      const double next = -b - std::sqrt(reach);
      if (next > at) {
        if (!visit(layer, at, next - at)) return WalkEnd::stopped;
        at = next;
      }
      if (layer == 0) return WalkEnd::ground;
      --layer;
    }
  }
  for (; layer < extinction_.size(); ++layer) {
    const double next =
        -b + std::sqrt(std::fmax(0.0, radius_[layer + 1] * radius_[layer + 1] - closest_squared));
    if (next <= at) continue;
    if (!visit(layer, at, next - at)) return WalkEnd::stopped;
    at = next;
  }
  return WalkEnd::top;
}

}  // namespace skylut::monte_carlo
