#include "lines_of_sight.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "../geometry/outside_view.hpp"

namespace skylut::transfer {

std::vector<std::vector<LineOfSight>> lines_of_sight(const Shells& shells, std::span<const SunBand> bands,
                                                     std::span<const Sight> sights) {
  struct Key {
    std::size_t band;
    double observer_km;
    double view_zenith_deg;
    auto operator<=>(const Key&) const = default;
  };
  const double top_km = shells.levels_km.back();
  std::vector<Key> key(sights.size());
  std::vector<SunAzimuth> pair(sights.size());
  std::vector<std::size_t> order;  // of what does not miss the air
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const Sight& sight = sights[i];
    pair[i] = {sight.sun_zenith_deg, sight.view.relative_azimuth_deg};
    if (sight.observer_altitude_km <= top_km) {
      key[i] = {band_of(bands, sight.sun_zenith_deg), sight.observer_altitude_km, sight.view.zenith_deg};
    } else {
      const std::optional<ViewAndSun> entry =
          view_from_entry(shells.planet_radius_km, top_km, sight.observer_altitude_km,
                          {sight.view.zenith_deg, sight.sun_zenith_deg, sight.view.relative_azimuth_deg});
      if (!entry) continue;
      key[i] = {bands.size() - 1, top_km, entry->view_zenith_deg};
      pair[i] = {entry->sun_zenith_deg, entry->relative_azimuth_deg};
    }
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });

  std::vector<std::vector<LineOfSight>> lines(bands.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Key& own_key = key[order[i]];
    std::vector<LineOfSight>& own = lines[own_key.band];
    if (i == 0 || own_key != key[order[i - 1]])
      own.push_back({own_key.observer_km, own_key.view_zenith_deg, {}, {}});
    own.back().pairs.push_back(pair[order[i]]);
    own.back().sights.push_back(order[i]);
  }
  return lines;
}

}  // namespace skylut::transfer
