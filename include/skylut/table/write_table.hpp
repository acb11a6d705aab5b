#pragma once

#include <filesystem>

#include "skylut/core/provenance.hpp"
#include "skylut/table/fit_table.hpp"

namespace skylut {

/// Writes table.csv and table.json, which holds its hash: both whole or neither. A table.json that does not
/// belong to the table.csv beside it is refused by Table::read.
/// @param folder  exists
/// @throws WorkError  naming the file that cannot be written
void write_table(const std::filesystem::path& folder, const SkyTable& table, const Provenance& provenance);

}  // namespace skylut
