#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/table/table_entry.hpp"
#include "skylut/table/table_model.hpp"

namespace skylut {

/// A sky at conditions that a table has no row for, and the row that it would be alone.
struct HeldOutSky {
  TableEntry alone;
  std::vector<Direction> directions;
  std::vector<double> solid_angles;  ///< [direction], of any sum
  std::vector<Yxy> colours;          ///< [direction], simulated; Y in cd/m²
};

/// Errors over the skies of a set: root mean square by solid angle of each sky, relative for Y, absolute for
/// x and y; of all skies the median, the 90th percentile and the worst.
struct ErrorSpread {
  double median = 0.0;
  double p90 = 0.0;
  double worst = 0.0;
};

/// How much worse a table is between its rows than a row fitted there would be.
struct BetweenNodesError {
  std::size_t skies = 0;
  double sun_zenith_to_deg = 90.0;  ///< of the skies
  ErrorSpread Y, x, y;              ///< of the table
  ErrorSpread Y_alone, x_alone, y_alone;
  std::size_t close = 0;     ///< skies whose error of Y is at most 1.2 times that of the row alone + 0.01
  SkyConditions worst_of_Y;  ///< where
};

/// Altitudes, loads and suns that are spread evenly (Halton 1960, bases 2, 3, 5) over a box: the same for
/// the same box.
/// @param loads           how many different ones
/// @param skies_per_load  each of another altitude and sun
std::vector<SkyConditions> held_out_conditions(const Range& altitude_km, TurbidityKind kind,
                                               const Range& turbidity, const Range& sun_zenith_deg,
                                               std::size_t loads, std::size_t skies_per_load);

/// @param skies  one or more, within the table's domain
BetweenNodesError between_nodes_error(const TableModel& table, std::span<const HeldOutSky> skies);

/// What table.json says of it.
nlohmann::ordered_json between_nodes_json(const BetweenNodesError& error);

}  // namespace skylut
