#include "shell_walk.hpp"

#include <limits>

namespace skylut::monte_carlo {

Vector normalised(const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vector turned(const Vector& direction, double cos_angle, double azimuth) {
  // An orthonormal pair across the direction, built from the axis least aligned with it.
  const double sine = std::sqrt(std::fmax(0.0, 1.0 - cos_angle * cos_angle));
  const Vector axis = std::abs(direction[2]) < 0.7 ? Vector{0.0, 0.0, 1.0} : Vector{1.0, 0.0, 0.0};
  const Vector across = normalised({direction[1] * axis[2] - direction[2] * axis[1],
                                    direction[2] * axis[0] - direction[0] * axis[2],
                                    direction[0] * axis[1] - direction[1] * axis[0]});
  const Vector third = {direction[1] * across[2] - direction[2] * across[1],
                        direction[2] * across[0] - direction[0] * across[2],
                        direction[0] * across[1] - direction[1] * across[0]};
  const double u = sine * std::cos(azimuth);
  const double v = sine * std::sin(azimuth);
  return normalised({cos_angle * direction[0] + u * across[0] + v * third[0],
                     cos_angle * direction[1] + u * across[1] + v * third[1],
                     cos_angle * direction[2] + u * across[2] + v * third[2]});
}

ShellWalk::ShellWalk(const Shells& shells, const OpticalColumn& column) {
  for (double level : shells.levels_km) radius_.push_back(shells.planet_radius_km + level);
  for (std::size_t i = 0; i < column.extinction_depth.size(); ++i)
    extinction_.push_back(column.extinction_depth[i] / (shells.levels_km[i + 1] - shells.levels_km[i]));
}

double ShellWalk::depth_to_top(const PhotonPosition& from, const Vector& direction) const {
  double depth = 0.0;
  const WalkEnd end = walk(from, direction, [&](std::size_t layer, double, double length) {
    depth += extinction_[layer] * length;
    return true;
  });
  return end == WalkEnd::ground ? std::numeric_limits<double>::infinity() : depth;
}

}  // namespace skylut::monte_carlo
