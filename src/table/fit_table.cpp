#include "skylut/table/fit_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <numeric>
#include <string>
#include <vector>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"

namespace skylut {

namespace {

constexpr double kCandelaPerKilocandela = 1000.0;

SkyFit fit_map(const SkyMap& map, std::size_t row, const SkyFitOptions& options) {
  try {
    return fit_sky(map.directions, map.colour, map.sun, options);
  } catch (const InputError& error) {
    throw InputError("row {} (altitude {} km, turbidity {}, sun {}:{}): {}", row, map.altitude_km,
                     map.turbidity.value, map.sun.zenith_deg, map.sun.azimuth_deg, error.what());
  }
}

/// A sky as the fit sees it, in an order of its own: mirror images (the same sun in the east and in the west)
/// are equal. What fit_sky makes of equal skies is equal to the last bit.
struct SortedSky {
  double sun_zenith_deg;
  std::vector<std::array<double, 5>> samples;  // zenith angle, angle to the sun, Y, x, y
  std::vector<std::size_t> order;              // of the samples in the map

  explicit SortedSky(const SkyMap& map) : sun_zenith_deg(map.sun.zenith_deg), order(map.directions.size()) {
    std::vector<std::array<double, 5>> unsorted;
    for (std::size_t i = 0; i < order.size(); ++i)
      unsorted.push_back({map.directions[i].zenith_deg, angle_between(map.directions[i], map.sun),
                          map.colour[i].Y, map.colour[i].x, map.colour[i].y});
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return unsorted[a] < unsorted[b]; });
    for (const std::size_t i : order) samples.push_back(unsorted[i]);
  }
  auto key() const { return std::pair(sun_zenith_deg, samples); }
};

/// The fit of a sky's mirror image: only the places of its worst directions differ.
SkyFit mirrored_fit(SkyFit fit, const SortedSky& fitted, const SortedSky& image) {
  for (FitReport* report : {&fit.Y, &fit.x, &fit.y}) {
    const auto at = std::find(fitted.order.begin(), fitted.order.end(), report->worst_direction);
    report->worst_direction = image.order[static_cast<std::size_t>(at - fitted.order.begin())];
  }
  return fit;
}

TableEntry table_entry(const SkyMap& map, const SkyFit& fit) {
  TableEntry entry;
  entry.altitude_km = map.altitude_km;
  entry.turbidity = map.turbidity.value;
  entry.sun = map.sun;
  entry.Y = fit.Y.coefficients;
  entry.x = fit.x.coefficients;
  entry.y = fit.y.coefficients;
  entry.zenith = {fit.zenith.Y / kCandelaPerKilocandela, fit.zenith.x, fit.zenith.y};
  entry.rmse_Y_rel = fit.Y.rmse;
  entry.rmse_x = fit.x.rmse;
  entry.rmse_y = fit.y.rmse;
  return entry;
}

}  // namespace

SkyTable fit_table(const Context& context, std::span<const SkyMap> maps, const SkyFitOptions& options) {
  SkyTable table;
  table.entries.resize(maps.size());
  table.fits.resize(maps.size());
  std::vector<SortedSky> skies;
  std::map<std::pair<double, std::vector<std::array<double, 5>>>, std::size_t> first_of;
  std::vector<std::size_t> first;  // per map: the first that is equal to it
  std::vector<std::size_t> to_be_fitted;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    skies.emplace_back(maps[i]);
    const auto [known, is_new] = first_of.emplace(skies.back().key(), i);
    first.push_back(known->second);
    if (is_new) to_be_fitted.push_back(i);
  }

  std::mutex one_at_a_time;
  std::size_t done = maps.size() - to_be_fitted.size();
  parallel_for(to_be_fitted.size(), context.threads, [&](std::size_t task) {
    const std::size_t i = to_be_fitted[task];
    table.fits[i] = fit_map(maps[i], i + 1, options);
    const std::lock_guard lock(one_at_a_time);
    if (context.progress) context.progress("fitting", ++done, maps.size());
  });
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (first[i] != i) table.fits[i] = mirrored_fit(table.fits[first[i]], skies[first[i]], skies[i]);
    table.entries[i] = table_entry(maps[i], table.fits[i]);
  }
  return table;
}

void require_converged(const SkyTable& table) {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < table.fits.size(); ++i)
    if (const std::string channels = unconverged_channels(table.fits[i]); !channels.empty())
      rows.push_back(fmt::format("{} ({})", i + 1, channels));
  if (!rows.empty())
    throw WorkError("fits that did not converge, whose coefficients are not those of a minimum: rows {}",
                    fmt::join(rows, ", "));
}

}  // namespace skylut
