#pragma once

#include <memory>
#include <vector>

#include "skylut/models/channel_sky.hpp"
#include "skylut/models/hosek_wilkie.hpp"

namespace skylut {

/// Control points of the quintic Bézier curves of one channel at one node: nine coefficients and the expected
/// radiance L_M, the mean over the dome by solid angle.
struct HosekWilkieCurves {
  static constexpr std::size_t kDegree = 5;
  using Curve = std::array<double, kDegree + 1>;
  std::array<Curve, 9> coefficients{};
  Curve mean{};
};

/// Nodes of the axes, ascending, and the curves at each.
struct HosekWilkieGrid {
  std::vector<double> altitudes_km;
  std::vector<double> turbidities;
  std::vector<double> albedos;
  SkyChannels channels;
  std::vector<HosekWilkieCurves> curves;  ///< [altitude][turbidity][albedo][channel]

  std::size_t index(std::size_t altitude, std::size_t turbidity, std::size_t albedo,
                    std::size_t channel = 0) const {
    return ((altitude * turbidities.size() + turbidity) * albedos.size() + albedo) * channels.size() +
           channel;
  }
};

/// A sky model of Hosek and Wilkie's form: between turbidities and albedos the skies of the four neighbouring
/// nodes are blended linearly, between altitudes in their logarithms.
class HosekWilkieModel final : public SkyModel {
 public:
  HosekWilkieModel(ModelInfo info, HosekWilkieGrid grid);

  const ModelInfo& info() const override { return frame_->info; }
  const HosekWilkieGrid& grid() const { return grid_; }

  /// @throws InputError  for conditions outside info()
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;

  /// The numbers of a model file, in nine digits, and back.
  static nlohmann::ordered_json json(const HosekWilkieGrid& grid);
  static std::unique_ptr<const SkyModel> read(const ModelInfo& info, const JsonReader& model);

 private:
  std::shared_ptr<const ModelFrame> frame_;
  HosekWilkieGrid grid_;
};

}  // namespace skylut
