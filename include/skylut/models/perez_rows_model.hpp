#pragma once

#include <memory>
#include <vector>

#include "skylut/models/channel_sky.hpp"
#include "skylut/models/perez.hpp"

namespace skylut {

/// One sky as Perez formulas, one per channel.
struct PerezRow {
  double altitude_km = 0.0;
  double turbidity = 0.0;
  double sun_zenith_deg = 0.0;
  std::vector<PerezCoefficients> coefficients;  ///< [channel]
  std::vector<double> zenith;                   ///< value of each channel at the zenith
};

/// Perez formulas at a set of conditions. Where the rows fill a grid of altitudes, turbidities and suns,
/// skies between them are blends of their neighbours': linear in altitude, turbidity and the sun's zenith
/// angle, of the logarithms of light and of chromaticities, each neighbour's formula taken at the angles of
/// the view to the vertical and to the sun that is asked for. Where they do not, only the rows' own
/// conditions have skies.
class PerezRowsModel final : public SkyModel {
 public:
  /// @param rows  one or more, of different conditions
  PerezRowsModel(ModelInfo info, SkyChannels channels, std::vector<PerezRow> rows);

  const ModelInfo& info() const override { return frame_->info; }
  const std::vector<PerezRow>& rows() const { return rows_; }
  bool fills_a_grid() const { return !grid_.empty(); }

  /// @throws InputError  for conditions outside info(), or that no row has if they fill no grid
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;

  /// The numbers of a model file, and back.
  static nlohmann::ordered_json json(const SkyChannels& channels, const std::vector<PerezRow>& rows);
  static std::unique_ptr<const SkyModel> read(const ModelInfo& info, const JsonReader& model);

 private:
  BlendedSky::Part part(const SkyConditions& conditions, const PerezRow& row, double weight) const;

  std::shared_ptr<const ModelFrame> frame_;
  std::vector<PerezRow> rows_;
  std::vector<double> altitudes_km_;  // ascending, each once
  std::vector<double> turbidities_;
  std::vector<double> suns_deg_;
  std::vector<std::size_t> grid_;  // row of [altitude][turbidity][sun]; empty: the rows fill no grid
};

}  // namespace skylut
