#pragma once

#include <array>
#include <string>

#include "skylut/fit/fit_sky.hpp"
#include "skylut/table/table_entry.hpp"
#include "skylut/table/table_sky.hpp"

namespace skylut::table_detail {

/// A view as the formula of a sky takes it: its zenith angle stretched so that the formula's horizon lies at
/// 90°, its true angle to the sun.
SkyDirection formula_view(const TableSky& sky, const RelativeView& view);

/// Fills the row's errors: the formulas against the sky's check directions, by solid angle.
void add_errors(TableEntry& entry, const TableSky& sky);

/// A digit for each flag, "10010".
std::string flags_text(const std::array<bool, 5>& flags);

}  // namespace skylut::table_detail
