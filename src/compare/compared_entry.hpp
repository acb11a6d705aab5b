#pragma once

#include "skylut/compare/compare_report.hpp"
#include "skylut/table/table_entry.hpp"

namespace skylut {

/// A table's row as the sky called "ours"; without one, the same columns left empty.
inline ComparedSky our_sky(const TableEntry* entry) {
  if (entry == nullptr) return {"ours", "", "kcd_m2", {}, {{"Y", {}}, {"x", {}}, {"y", {}}}};
  return {"ours", "", "kcd_m2", entry->zenith, {{"Y", entry->Y}, {"x", entry->x}, {"y", entry->y}}};
}

}  // namespace skylut
