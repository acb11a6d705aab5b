#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "skylut/table/table.hpp"

namespace skylut {

/// What table.json says about the table beside it.
struct TableManifest {
  TurbidityKind turbidity_kind = TurbidityKind::aod500;
  TableProvenance provenance;
  std::vector<ListedTurbidity> turbidities;
};

/// @param csv  the table that is read; nothing comes back if table.json belongs to a file of another name
/// @throws InputError  no JSON of skylut table, or a csv with other content than table.json was written with
std::optional<TableManifest> read_table_json(const std::filesystem::path& json,
                                             const std::filesystem::path& csv);

}  // namespace skylut
