#pragma once

#include <memory>
#include <vector>

#include "skylut/models/channel_sky.hpp"
#include "skylut/models/preetham_matrices.hpp"

namespace skylut {

/// Matrices of one observer.
struct PreethamLevel {
  double altitude_km = 0.0;
  PreethamMatrices matrices;
};

/// A sky model of Preetham's form with matrices fitted to other skies, for one or more altitudes; between two
/// of them the skies are blended in the logarithm of luminance and in chromaticity.
class PreethamModel final : public SkyModel {
 public:
  /// @param levels  one or more, altitudes ascending
  PreethamModel(ModelInfo info, std::vector<PreethamLevel> levels);

  const ModelInfo& info() const override { return frame_->info; }
  const std::vector<PreethamLevel>& levels() const { return levels_; }

  /// @throws InputError  for conditions outside info()
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;

  /// The numbers of a model file, and back.
  static nlohmann::ordered_json json(const std::vector<PreethamLevel>& levels);
  static std::unique_ptr<const SkyModel> read(const ModelInfo& info, const JsonReader& model);

 private:
  std::shared_ptr<const ModelFrame> frame_;
  std::vector<PreethamLevel> levels_;
};

}  // namespace skylut
