#pragma once

#include <filesystem>
#include <vector>

#include "skylut/core/directions.hpp"

namespace skylut {

/// Reads directions of view: a comma-separated file whose header names the columns zenith_deg (within
/// 0 to 180) and azimuth_deg (clockwise from north, any turn, brought to [0, 360)), in any order; other
/// columns are ignored, so that a sky.csv will do. Lines that begin with # are comments.
/// @throws InputError  "file:line: what is wrong, what would be right"; no such file; no rows
std::vector<Direction> read_directions_csv(const std::filesystem::path& path);

}  // namespace skylut
