#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/table/table_entry.hpp"

namespace skylut {

struct Context;

/// The values that a table's rows take, each once, in the order in which the rows have them.
struct TableAxes {
  std::vector<double> altitudes_km;
  std::vector<double> turbidities;
  std::vector<Direction> suns;
};

/// How a table came about, as its table.json says.
struct TableProvenance {
  std::string skylut_version;
  std::string command;  ///< that makes the table again
  std::string inputs;   ///< JSON text of every number that went into it; empty if there is none
  std::optional<double> ground_albedo;  ///< that it was made with; none if it varies with the wavelength
  std::string between_nodes;  ///< JSON text of what it states of its error between its rows; empty: nothing
};

/// A turbidity of the table in every kind that table.json lists, for the table's own air.
struct ListedTurbidity {
  double given = 0.0;
  std::map<TurbidityKind, double> by_kind;
};

/// A coefficient table: rows, axes, what its turbidity means, and where it comes from.
class Table {
 public:
  /// @throws InputError  no rows, or two rows of the same altitude, turbidity and sun
  explicit Table(std::vector<TableEntry> entries, TurbidityKind kind = TurbidityKind::aod500);

  /// Reads a table from its folder, or from a table.csv, and the table.json beside it if there is one.
  /// @param kind  of the turbidity; what table.json says goes before the default, aod500
  /// @throws InputError  "file:line: what is wrong, what would be right"; a table.csv that is not the one
  /// that
  ///                     table.json was written with; a kind other than table.json's
  static Table read(const std::filesystem::path& folder_or_csv, std::optional<TurbidityKind> kind = {});

  const std::vector<TableEntry>& entries() const { return entries_; }
  const TableAxes& axes() const { return axes_; }
  TurbidityKind turbidity_kind() const { return kind_; }
  const std::optional<TableProvenance>& provenance() const { return provenance_; }

  /// The row of exactly these conditions; null if there is none.
  const TableEntry* find(double altitude_km, double turbidity, const Direction& sun) const;

  /// axes().turbidities in another kind: as table.json lists them for the table's own air, else through the
  /// 1976 standard atmosphere with the haze of AerosolOptics{}.
  /// @throws InputError  if table.json lacks one; as to_aod500
  std::vector<double> turbidities_as(const Context& context, TurbidityKind kind) const;

  /// Any turbidity in the table's kind: as table.json converts the table's own, straight between and beyond
  /// them in optical depth, which every kind is proportional to (visibility inversely) but for a constant;
  /// else as turbidities_as.
  /// @throws InputError  as turbidities_as; if a table.json of one turbidity would have to convert others
  Turbidity in_own_kind(const Context& context, const Turbidity& turbidity) const;

  /// Where turbidities_as takes its numbers from, for a heading.
  std::string conversion_source(TurbidityKind kind) const;

 private:
  std::vector<TableEntry> entries_;
  TableAxes axes_;
  TurbidityKind kind_;
  std::optional<TableProvenance> provenance_;
  std::vector<ListedTurbidity> listed_;
};

}  // namespace skylut
