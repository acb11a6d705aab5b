#include "lines_of_sight.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace skylut::transfer {

std::vector<std::vector<LineOfSight>> lines_of_sight(std::span<const SunBand> bands,
                                                     std::span<const Sight> sights) {
  struct Key {
    std::size_t band;
    double observer_km;
    double view_zenith_deg;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<Key> key;
  for (const Sight& sight : sights)
    key.push_back({band_of(bands, sight.sun_zenith_deg), sight.observer_altitude_km, sight.view.zenith_deg});
  std::vector<std::size_t> order(sights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });

  std::vector<std::vector<LineOfSight>> lines(bands.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Sight& sight = sights[order[i]];
    std::vector<LineOfSight>& own = lines[key[order[i]].band];
    if (i == 0 || key[order[i]] != key[order[i - 1]])
      own.push_back({sight.observer_altitude_km, sight.view.zenith_deg, {}, {}});
    own.back().pairs.push_back({sight.sun_zenith_deg, sight.view.relative_azimuth_deg});
    own.back().sights.push_back(order[i]);
  }
  return lines;
}

}  // namespace skylut::transfer
