#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "skylut/table/table_entry.hpp"

namespace skylut {

/// The header line of table.csv: altitude_km,turbidity,sun_zenith_deg,sun_azimuth_deg, A_Y…E_Y, A_x…E_x,
/// A_y…E_y, Y_zenith_kcd_m2,x_zenith,y_zenith, rmse_Y_rel,rmse_x,rmse_y.
std::string table_csv_header();

/// The text of table.csv: header, one row per entry, each number in the fewest digits that read back to the
/// same double. The same entries give the same bytes.
std::string format_table_csv(std::span<const TableEntry> entries);

/// Writes format_table_csv under `path`, whole or not at all. @throws WorkError
void write_table_csv(const std::filesystem::path& path, std::span<const TableEntry> entries);

/// Reads a table.csv. Columns may stand in any order, all must be there, others are ignored; lines that
/// begin with # are comments.
/// @throws InputError  "file:line: what is wrong, what would be right"; no such file; no rows
std::vector<TableEntry> read_table_csv(const std::filesystem::path& path);

}  // namespace skylut
