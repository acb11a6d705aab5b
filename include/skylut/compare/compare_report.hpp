#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "skylut/table/table_entry.hpp"
#include "skylut/table/table_turbidity.hpp"

namespace skylut {

struct Context;

/// A comparison as rows of named cells: the same content as text, CSV and JSON.
struct CompareReport {
  using Cell =
      std::variant<std::monostate, double, std::string>;  ///< empty where there is nothing to compare

  std::string name;                ///< of what the table is compared with
  std::vector<std::string> notes;  ///< what a reader must know
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> blocks;  ///< rows as a reader takes them, one text per row

  std::string text() const;
  std::string csv() const;
  std::string json() const;
};

/// Every entry at 0 km beside Preetham 1999 for the same turbidity and sun.
/// @throws InputError  if no entry is at 0 km with the sun above the horizon and T >= 1
CompareReport compare_with_preetham1999(std::span<const TableEntry> entries, const TableTurbidity& turbidity);

/// Every legible published row, its verdict, and the entry of the table for the same altitude, turbidity and
/// sun.
CompareReport compare_with_utm2005(const Context& context, std::span<const TableEntry> entries);

}  // namespace skylut
