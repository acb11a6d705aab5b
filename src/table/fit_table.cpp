#include "skylut/table/fit_table.hpp"

#include <mutex>

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

SkyTable fit_table(std::span<const SkyMap> maps, const SkyFitOptions& options, int threads,
                   const std::function<void(std::size_t, std::size_t)>& progress) {
  SkyTable table;
  table.entries.resize(maps.size());
  table.fits.resize(maps.size());
  std::mutex one_at_a_time;
  std::size_t done = 0;
  parallel_for(maps.size(), threads, [&](std::size_t i) {
    table.fits[i] = fit_map(maps[i], i + 1, options);
    table.entries[i] = table_entry(maps[i], table.fits[i]);
    const std::lock_guard lock(one_at_a_time);
    if (progress) progress(++done, maps.size());
  });
  return table;
}

}  // namespace skylut
