#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "skylut/fit/fit_sky.hpp"
#include "skylut/sky/sky_map.hpp"
#include "skylut/table/table_entry.hpp"

namespace skylut {

/// A table of fitted skies: its rows and, in the same order, what each fit reports.
struct SkyTable {
  std::vector<TableEntry> entries;
  std::vector<SkyFit> fits;
};

/// Fits every map, in parallel; row i is map i. A row does not depend on the other maps nor on the
/// number of threads.
/// @param threads   0: all cores
/// @param progress  called with (maps done, maps in all), one call at a time; may be empty
/// @throws InputError  naming the row, if a map cannot be fitted (fit_sky says why)
SkyTable fit_table(std::span<const SkyMap> maps, const SkyFitOptions& options, int threads,
                   const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace skylut
