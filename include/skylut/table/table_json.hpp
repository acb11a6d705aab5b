#pragma once

#include <optional>
#include <string>

#include "skylut/site/place.hpp"
#include "skylut/sky/simulate_sky.hpp"
#include "skylut/table/fit_table.hpp"

namespace skylut {

struct Context;

/// How a table came about, besides the scene itself.
struct TableOrigin {
  std::string command;         ///< the command line that makes the same table again
  std::string quality;         ///< of the transfer
  std::string weights;         ///< of the fit
  std::string directions;      ///< name of the set of directions
  std::optional<Place> place;  ///< if gravity and radius were taken from a place
};

/// table.json: version, units, every input with the whole profile, and for each row the coefficients
/// with what the fits report. Objects keep a fixed order; the same table gives the same bytes. Numbers
/// that are not finite are written as null.
std::string table_json(const Context& context, const SkyTable& table, const SkyScene& scene,
                       const TableOrigin& origin);

}  // namespace skylut
