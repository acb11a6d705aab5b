#include "skylut/table/write_table.hpp"

#include <array>
#include <string>

#include "skylut/core/atomic_file.hpp"
#include "skylut/table/table_csv.hpp"
#include "skylut/table/table_json.hpp"

namespace skylut {

void write_table(const std::filesystem::path& folder, const SkyTable& table, const Provenance& provenance) {
  const std::string csv = format_table_csv(table.entries);
  const std::string json = table_json(table, provenance);
  write_texts_atomically(
      std::array{FileText{folder / "table.csv", csv}, FileText{folder / "table.json", json}});
}

}  // namespace skylut
