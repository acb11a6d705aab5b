#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skylut/models/perez_sky.hpp"
#include "skylut/models/sky_model.hpp"
#include "skylut/table/table.hpp"

namespace skylut {

class RowGrid;

/// How the sky between a table's rows comes about.
enum class TableRule {
  blend,   ///< the rows around, by the logarithms of their colours [fit.md T1-T3]
  utm2005  ///< the same for turbidity and sun, but Lagrange's cubic on Y, x, y through four altitudes: the
           ///< UTM report's rule (2005 §3.2.2.2), errors of which fit.md T4 has
};

struct TableModelOptions {
  TableRule rule = TableRule::blend;
  bool extrapolate = false;  ///< beyond the table's nodes the nearest ones go on
};

/// A fitted table as a sky model: its rows' own formulas at its nodes, a blend of the rows around between
/// them.
///
/// Altitude, turbidity and the sun's zenith angle are axes; azimuths count relative to the sun. Below the
/// lowest sun of a table that begins within 5° of the zenith, that row and its mirror image on the other side
/// of the zenith are the rows around.
/// Accuracy: table.json of a table made with --grid runtime states it (between_nodes); fit.md T5 has figures.
class TableModel final : public SkyModel {
 public:
  explicit TableModel(Table table, const TableModelOptions& options = {});
  ~TableModel() override;

  /// Ranges are those of the table's axes; the albedo is whatever the table was made with.
  const ModelInfo& info() const override { return info_; }
  const Table& table() const { return table_; }

  /// In words: what is interpolated and how, for a file's provenance.
  std::string rule() const;

  /// Whether the conditions are those of a row (for a sun of any azimuth), so that nothing is interpolated.
  bool is_node(const SkyConditions& conditions) const;

  /// The views that its sky has light for there; info() has those of any conditions.
  Range view_zenith_deg(const SkyConditions& conditions) const;

  /// @return a PerezSky at a row's conditions
  /// @throws InputError  outside the table's domain (unless extrapolating); between the rows of a table that
  ///                     lacks a combination of its values, naming these; by the rule utm2005 with fewer than
  ///                     four altitudes
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;

 private:
  const TableEntry* row(const SkyConditions& conditions) const;
  double horizon_zenith_deg(double altitude_km) const;
  std::unique_ptr<const Sky> blended(const SkyConditions& conditions, double horizon_zenith_deg) const;
  std::unique_ptr<const Sky> summed_over_altitudes(const SkyConditions& conditions) const;

  Table table_;
  TableModelOptions options_;
  ModelInfo info_;
  std::unique_ptr<const RowGrid> grid_;  // none: a combination is missing
};

/// One row as a sky.
PerezSky sky_of(const TableEntry& entry);

}  // namespace skylut
