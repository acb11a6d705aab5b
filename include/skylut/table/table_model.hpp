#pragma once

#include "skylut/models/perez_sky.hpp"
#include "skylut/models/sky_model.hpp"
#include "skylut/table/table.hpp"

namespace skylut {

/// A fitted table as a sky model: its rows, and nothing between them.
class TableModel final : public SkyModel {
 public:
  explicit TableModel(Table table);

  /// Ranges are those of the table's axes; the albedo is whatever the table was made with.
  const ModelInfo& info() const override { return info_; }

  /// @return a PerezSky
  /// @throws InputError  naming the values that the table has, unless a row has exactly these conditions
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;

 private:
  Table table_;
  ModelInfo info_;
};

/// One row as a sky.
PerezSky sky_of(const TableEntry& entry);

}  // namespace skylut
