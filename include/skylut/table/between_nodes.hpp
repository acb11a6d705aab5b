#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "skylut/table/held_out_skies.hpp"
#include "skylut/table/table_model.hpp"

namespace skylut {

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
  ErrorSpread Y, x, y;  ///< of the table
  ErrorSpread Y_alone, x_alone, y_alone;
  std::size_t close = 0;     ///< skies whose error of Y is at most 1.2 times that of the row alone + 0.01
  SkyConditions worst_of_Y;  ///< where
};

/// @param skies  one or more, within the table's domain
BetweenNodesError between_nodes_error(const TableModel& table, std::span<const HeldOutSky> skies);

/// What table.json says of it: errors of the skies with the sun up and, if there are any, below the horizon.
nlohmann::ordered_json between_nodes_json(const TableModel& table, std::span<const HeldOutSky> skies);

}  // namespace skylut
