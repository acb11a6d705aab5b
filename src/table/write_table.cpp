#include "skylut/table/write_table.hpp"

#include "skylut/core/atomic_file.hpp"
#include "skylut/table/table_csv.hpp"
#include "skylut/table/table_json.hpp"

namespace skylut {

void write_table(const std::filesystem::path& folder, const SkyTable& table,
                 const std::vector<Direction>& directions, const Provenance& provenance) {
  write_table_csv(folder / "table.csv", table.entries);
  write_text_atomically(folder / "table.json", table_json(table, directions, provenance));
}

}  // namespace skylut
