#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "skylut/fit/fit_sky.hpp"
#include "skylut/sky/sky_map.hpp"
#include "skylut/table/table_entry.hpp"

namespace skylut {

struct Context;

/// A table of fitted skies: its rows and, in the same order, what each fit reports.
struct SkyTable {
  std::vector<TableEntry> entries;
  std::vector<SkyFit> fits;
  std::string between_nodes;  ///< JSON text of between_nodes_json(); empty: not measured
};

/// Fits every map, in parallel; row i is map i. A row does not depend on the other maps nor on the
/// number of threads.
/// @param context  threads and progress
/// @throws InputError  naming the row, if a map cannot be fitted (fit_sky says why)
SkyTable fit_table(const Context& context, std::span<const SkyMap> maps, const SkyFitOptions& options);

/// @throws WorkError  naming the rows whose fits did not converge
void require_converged(const SkyTable& table);

}  // namespace skylut
