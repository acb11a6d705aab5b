#pragma once

#include <string>
#include <vector>

#include "options/options.hpp"
#include "skylut/core/directions.hpp"

namespace skylut::cli {

/// --directions of commands that write a sky's numbers.
Option& add_directions(OptionSet& options, std::optional<std::string>& name_or_file);

/// utm271, preetham343 or those of a CSV file. @throws InputError  naming the text, as read_directions_csv
std::vector<Direction> directions_of(const std::string& name_or_file);

}  // namespace skylut::cli
