#include "shell_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skylut/core/check.hpp"

namespace skylut::transfer {

ShellGeometry::ShellGeometry(std::vector<double> levels_km, double planet_radius_km)
    : levels_km_(std::move(levels_km)), planet_radius_km_(planet_radius_km) {
  SKYLUT_CHECK_GE(levels_km_.size(), 2U);
  SKYLUT_CHECK(std::is_sorted(levels_km_.begin(), levels_km_.end()));
}

int ShellGeometry::layer_of(double altitude_km) const {
  const auto above = std::upper_bound(levels_km_.begin(), levels_km_.end(), altitude_km);
  return std::clamp(static_cast<int>(above - levels_km_.begin()) - 1, 0, layers() - 1);
}

bool ShellGeometry::path_to_top(double altitude_km, double cos_zenith, std::vector<double>& length_km) const {
  SKYLUT_CHECK_GE(altitude_km, 0.0);
  const double radius = planet_radius_km_ + altitude_km;
  const double along = radius * cos_zenith;  // signed distance from the point closest to the centre
  // Distance from the closest point to a shell of altitude h: √(r_h² - p²), p² = r² - along².
  const auto from_closest = [&](double level_km) {
    const double square = radius_square_difference(level_km, altitude_km) + along * along;
    return square > 0.0 ? std::sqrt(square) : 0.0;
  };
  const bool down = cos_zenith < 0.0;
  if (down && radius_square_difference(0.0, altitude_km) + along * along > 0.0) return false;
  length_km.assign(static_cast<std::size_t>(layers()), 0.0);
  double below = 0.0;
  for (int layer = 0; layer < layers(); ++layer) {
    const double lower_km = level_km(layer);
    const double upper_km = level_km(layer + 1);
    const double above = from_closest(upper_km);
    if (down) {
      // Up to the starting altitude both branches of the chord are crossed, above it only the far one.
      double length = above - below;
      if (upper_km <= altitude_km)
        length += above - below;
      else if (lower_km < altitude_km)
        length += -along - below;
      length_km[static_cast<std::size_t>(layer)] = length;
    } else if (upper_km > altitude_km) {
      length_km[static_cast<std::size_t>(layer)] = above - (lower_km > altitude_km ? below : along);
    }
    below = above;
  }
  return true;
}

}  // namespace skylut::transfer
