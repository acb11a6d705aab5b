#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "skylut/colour/yxy.hpp"

namespace skylut {

/// One row of a sky.csv.
struct SkyCsvRow {
  double zenith_deg = 0.0;            ///< [0, 90]
  std::optional<double> azimuth_deg;  ///< absent if the file has no such column
  std::optional<double> gamma_deg;    ///< angle to the sun, [0, 180]; absent if the file has no such column
  Yxy colour;                         ///< Y in cd/m² (or whatever unit the file's Y has)
  std::size_t line = 0;               ///< in the file, from 1
};

/// A sky read from a file.
struct SkyCsv {
  std::vector<SkyCsvRow> rows;
  std::optional<double> sun_zenith_deg;   ///< from a comment line "# sun_zenith_deg=45"
  std::optional<double> sun_azimuth_deg;  ///< from a comment line "# sun_azimuth_deg=90"
};

/// Reads a sky: a comma-separated file whose header names the columns zenith_deg, azimuth_deg or gamma_deg
/// (or both), Y_cd_m2 (or Y), x, y, in any order; other columns, such as L_<nm>, are ignored. Lines that
/// begin with # are comments. Spaces around a field and CR LF line ends do not matter.
/// @throws InputError  "file:line: what is wrong, what would be right"; no such file; no rows
SkyCsv read_sky_csv(const std::filesystem::path& path);

}  // namespace skylut
