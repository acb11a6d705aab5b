#pragma once

#include <string>

#include "skylut/core/provenance.hpp"
#include "skylut/table/fit_table.hpp"

namespace skylut {

/// table.json: how the table came about (Provenance), units, and for each row the coefficients with what the
/// fits report. Objects keep a fixed order; the same table gives the same bytes. Numbers that are not finite
/// are written as null.
std::string table_json(const SkyTable& table, const Provenance& provenance);

}  // namespace skylut
