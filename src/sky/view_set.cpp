#include "skylut/sky/view_set.hpp"

#include <algorithm>

namespace skylut {

namespace {

bool is_vertical(double zenith_deg) { return zenith_deg == 0.0 || zenith_deg == 180.0; }

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <class T>
std::size_t index_of(const std::vector<T>& sorted, const T& value) {
  return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

}  // namespace

RelativeView relative_view(const Direction& view, const Direction& sun) {
  if (is_vertical(view.zenith_deg) || is_vertical(sun.zenith_deg)) return {view.zenith_deg, 0.0};
  return {view.zenith_deg, folded_relative_azimuth_deg(view.azimuth_deg, sun.azimuth_deg)};
}

ViewSet::ViewSet(std::span<const Direction> views, std::span<const Direction> suns) : views_(views.size()) {
  for (const Direction& sun : suns) {
    unique_sun_zeniths_deg_.push_back(sun.zenith_deg);
    for (const Direction& view : views) unique_views_.push_back(relative_view(view, sun));
  }
  sort_unique(unique_sun_zeniths_deg_);
  sort_unique(unique_views_);
  for (const Direction& sun : suns) {
    sun_index_.push_back(index_of(unique_sun_zeniths_deg_, sun.zenith_deg));
    for (const Direction& view : views)
      view_index_.push_back(index_of(unique_views_, relative_view(view, sun)));
  }
}

}  // namespace skylut
