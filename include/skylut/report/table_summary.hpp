#pragma once

#include <string>

#include "skylut/table/fit_table.hpp"

namespace skylut {

/// A table for reading on a screen: one line per row with the zenith's colour, how well the formulas
/// fit, and which coefficients need care (not determined by the data, or on a bound of the fit).
/// @param turbidity_kind  the name of the table's turbidity kind, for the heading
std::string table_summary(const SkyTable& table, const std::string& turbidity_kind);

}  // namespace skylut
