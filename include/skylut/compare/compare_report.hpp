#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/compare/metrics.hpp"
#include "skylut/core/provenance.hpp"
#include "skylut/models/perez.hpp"

namespace skylut {

/// One of the skies that a row sets side by side.
struct ComparedSky {
  std::string label;          ///< on the screen: "ours"
  std::string suffix;         ///< of its columns: "", "_preetham1999"
  std::string unit;           ///< of Y in column names: "kcd_m2"; empty where the source gives none
  std::optional<Yxy> zenith;  ///< absent: there is no such sky
  /// By channel, "Y", "x", "y", or "" for a source that prints one set; absent as the sky or for a model that
  /// has none. Every row of a report has the same channels.
  std::vector<std::pair<std::string, std::optional<PerezCoefficients>>> coefficients;
};

/// One row of a comparison.
struct CompareRow {
  using Cell =
      std::variant<std::monostate, double, std::string>;  ///< empty where there is nothing to compare

  std::vector<std::pair<std::string, Cell>> facts;  ///< conditions and verdict, by column
  std::vector<ComparedSky> skies;
  bool has_difference = false;              ///< whether the report has the columns
  std::optional<SkyDifference> difference;  ///< of the first sky from the second, over a dome

  /// Every cell with its column, for CSV and JSON.
  std::vector<std::pair<std::string, Cell>> cells() const;
  /// For a reader.
  std::string text() const;
};

/// A comparison: the same content as text, CSV and JSON.
struct CompareReport {
  std::string name;                ///< of what the table is compared with
  std::vector<std::string> notes;  ///< what a reader must know
  std::vector<CompareRow> rows;

  std::string text() const;
  std::string csv(const Provenance& provenance) const;
  std::string json(const Provenance& provenance) const;
};

}  // namespace skylut
