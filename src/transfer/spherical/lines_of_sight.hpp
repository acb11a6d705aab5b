#pragma once

#include <vector>

#include "ray_geometry.hpp"
#include "skylut/transfer/sky_radiance.hpp"

namespace skylut::transfer {

/// A line of sight wanted by a request: all views that share observer and zenith angle share its path.
struct LineOfSight {
  std::size_t observer;
  double view_zenith_deg;
  std::vector<std::size_t> views;  ///< indices into the request

  /// Suns and azimuths under which it is wanted: [sun][view].
  std::vector<SunAzimuth> pairs(const SkyRequest& request) const;
};

std::vector<LineOfSight> lines_of_sight(const SkyRequest& request);

}  // namespace skylut::transfer
