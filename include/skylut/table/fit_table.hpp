#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "skylut/fit/fit_sky.hpp"
#include "skylut/table/table_entry.hpp"
#include "skylut/table/table_sky.hpp"

namespace skylut {

struct Context;

/// A table of fitted skies: its rows and, in the same order, what each fit reports.
struct SkyTable {
  std::vector<TableEntry> entries;
  std::vector<SkyFit> fits;
  /// [row], of Y, x, y: what continuing the neighbours cost, the fit's cost over that of its best minimum,
  /// less 1.
  std::vector<std::array<double, 3>> cost_over_least;
  std::string grid;           ///< in words, what was looked at together to choose between equally good minima
  std::string between_nodes;  ///< JSON text of between_nodes_json(); empty: not measured
};

struct TableFitOptions {
  FitOptions fit;  ///< its residual kind is set per channel
  /// Of e^{Dγ} anywhere in the dome: bounds D from above, the closer the lower the sun.
  double largest_exponential = std::numeric_limits<double>::infinity();
  SampleWeights weights = SampleWeights::horizon;
  /// How much dearer than the least a minimum may be that continues its neighbours' branch; 0: every row is
  /// fitted alone.
  double branch_tolerance = 0.01;

  /// Bounds that keep every coefficient, and e^B at the zenith, within the normal numbers of half floats, and
  /// the formula at 89.9° as it is at 90°. [fit.md F7]
  static TableFitOptions half_floats();
  /// Every row alone, all directions alike, 32-bit floats: the UTM report's recipe.
  static TableFitOptions utm2005();
};

/// Fits the skies of a table, in parallel; row i is sky i. Skies that look the same from under their suns are
/// fitted once. Nothing depends on the number of threads.
/// @param skies    a full grid, [altitude][turbidity][sun]
/// @throws InputError  naming the row, if a sky cannot be fitted (fit_sky says why)
SkyTable fit_table(const Context& context, std::span<const TableSky> skies, const TableFitOptions& options);

/// @throws WorkError  naming the rows whose fits did not converge
void require_converged(const SkyTable& table);

}  // namespace skylut
