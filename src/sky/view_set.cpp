#include "skylut/sky/view_set.hpp"

#include <algorithm>

namespace skylut {

namespace {

bool is_vertical(double zenith_deg) { return zenith_deg == 0.0 || zenith_deg == 180.0; }

}  // namespace

RelativeView relative_view(const Direction& view, const Direction& sun) {
  if (is_vertical(view.zenith_deg) || is_vertical(sun.zenith_deg)) return {view.zenith_deg, 0.0};
  return {view.zenith_deg, folded_relative_azimuth_deg(view.azimuth_deg, sun.azimuth_deg)};
}

ViewSet::ViewSet(std::span<const Direction> views, std::span<const Direction> suns) : views_(views.size()) {
  std::vector<Pair> all;
  for (const Direction& sun : suns)
    for (const Direction& view : views) all.push_back({sun.zenith_deg, relative_view(view, sun)});
  pairs_ = all;
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  for (const Pair& pair : all)
    index_.push_back(
        static_cast<std::size_t>(std::lower_bound(pairs_.begin(), pairs_.end(), pair) - pairs_.begin()));
}

std::vector<Sight> ViewSet::sights(std::span<const double> altitudes_km) const {
  std::vector<Sight> all;
  for (const double altitude_km : altitudes_km)
    for (const Pair& pair : pairs_) all.push_back({altitude_km, pair.sun_zenith_deg, pair.view});
  return all;
}

}  // namespace skylut
