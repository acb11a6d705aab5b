#include "lines_of_sight.hpp"

#include <algorithm>
#include <numeric>

namespace skylut::transfer {

std::vector<SunAzimuth> LineOfSight::pairs(const SkyRequest& request) const {
  std::vector<SunAzimuth> pairs;
  for (const double sun : request.sun_zeniths_deg)
    for (const std::size_t view : views) pairs.push_back({sun, request.views[view].relative_azimuth_deg});
  return pairs;
}

std::vector<LineOfSight> lines_of_sight(const SkyRequest& request) {
  std::vector<std::size_t> order(request.views.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return request.views[a] < request.views[b]; });
  std::vector<LineOfSight> rays;
  for (std::size_t observer = 0; observer < request.observer_altitudes_km.size(); ++observer)
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double zenith = request.views[order[i]].zenith_deg;
      if (i == 0 || zenith != request.views[order[i - 1]].zenith_deg) rays.push_back({observer, zenith, {}});
      rays.back().views.push_back(order[i]);
    }
  return rays;
}

}  // namespace skylut::transfer
