#pragma once

#include <string>
#include <vector>

#include "skylut/core/directions.hpp"

namespace skylut::cli {

/// Directions by name ("utm271", "preetham343") or from a CSV file.
/// @throws InputError  if it is neither, or the file holds something else
std::vector<Direction> directions_of(const std::string& name_or_file);

}  // namespace skylut::cli
