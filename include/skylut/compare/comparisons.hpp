#pragma once

#include <string>
#include <vector>

#include "skylut/compare/compare_report.hpp"
#include "skylut/models/sky_model.hpp"
#include "skylut/table/table.hpp"

namespace skylut {

struct Context;

/// Every entry that the model's source vouches for in altitude and sun, beside the model's sky of the same
/// conditions: zeniths, coefficients of those that have them, and the difference over 271 directions.
/// @throws InputError  if there is no such entry; as Table::turbidities_as
CompareReport compare_with_model(const Context& context, const Table& table, const SkyModel& model);

/// Every legible published row of the UTM report 2005, its verdict, and the entry of the table for the same
/// altitude, turbidity and sun.
CompareReport compare_with_utm2005(const Context& context, const Table& table);

/// What a table can be compared with: the sky models of the registry, and published tables.
std::vector<std::string> comparison_names();

/// @param against  one of comparison_names()
/// @throws InputError  naming those there are
CompareReport compare_table(const Context& context, const Table& table, const std::string& against);

}  // namespace skylut
