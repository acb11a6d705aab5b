#include "outside_view.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

std::optional<ViewAndSun> view_from_entry(double planet_radius_km, double top_km, double altitude_km,
                                          const ViewAndSun& outside) {
  const double view = outside.view_zenith_deg * kRadiansPerDegree;
  const double sun = outside.sun_zenith_deg * kRadiansPerDegree;
  const double cos_azimuth = std::cos(outside.relative_azimuth_deg * kRadiansPerDegree);
  const double radius = planet_radius_km + altitude_km;
  const double top = planet_radius_km + top_km;
  const double closest = radius * std::sin(view);
  if (std::cos(view) >= 0.0 || closest >= top) return std::nullopt;
  // In the plane of the line, the vertical of the entry is turned by φ, the difference of its zenith angles.
  const double entry_view = kPi - std::asin(closest / top);
  const double turned = view - entry_view;
  const double towards_view = std::sin(sun) * cos_azimuth;
  const double entry_cos = std::cos(turned) * std::cos(sun) + std::sin(turned) * towards_view;
  const double along = std::cos(turned) * towards_view - std::sin(turned) * std::cos(sun);
  const double across = std::sin(sun) * std::sqrt(std::max(0.0, 1.0 - cos_azimuth * cos_azimuth));
  return ViewAndSun{entry_view * kDegreesPerRadian,
                    std::atan2(std::hypot(along, across), entry_cos) * kDegreesPerRadian,
                    std::atan2(across, along) * kDegreesPerRadian};
}

}  // namespace skylut::transfer
