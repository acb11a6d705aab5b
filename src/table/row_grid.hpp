#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "skylut/table/table.hpp"

namespace skylut {

/// The rows of a table on the axes between which it is interpolated. Only the sun's zenith angle is an axis:
/// a sky turns with its sun, so that rows of suns that differ in azimuth alone are one.
class RowGrid {
 public:
  /// Nothing if a combination of altitude, turbidity and sun zenith angle has no row.
  static std::optional<RowGrid> of(const Table& table);

  const std::vector<double>& altitudes_km() const { return altitudes_km_; }        ///< ascending
  const std::vector<double>& turbidities() const { return turbidities_; }          ///< ascending
  const std::vector<double>& sun_zeniths_deg() const { return sun_zeniths_deg_; }  ///< ascending

  /// Index of a row among the table's entries.
  std::size_t row(std::size_t altitude, std::size_t turbidity, std::size_t sun) const {
    return rows_[(altitude * turbidities_.size() + turbidity) * sun_zeniths_deg_.size() + sun];
  }

 private:
  std::vector<double> altitudes_km_;
  std::vector<double> turbidities_;
  std::vector<double> sun_zeniths_deg_;
  std::vector<std::size_t> rows_;  // [altitude][turbidity][sun]
};

}  // namespace skylut
