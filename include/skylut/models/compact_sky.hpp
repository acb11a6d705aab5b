#pragma once

#include <memory>

#include "skylut/models/sky_model.hpp"

namespace skylut {

class JsonReader;
namespace compact {
struct Tables;
class Expansion;
}  // namespace compact

/// The form `skylut`: skies at any altitude, aerosol load, ground albedo and sun, in every direction, from
/// some hundred thousand numbers. What is sharp in a sky, the phase functions, is kept apart; what is smooth
/// is interpolated in all conditions from a compressed table. Never negative. [docs/models.md]
///
/// Accuracy: measured at held-out conditions when the model is made and stated in its file. Cost: some tens
/// of µs per sky and some 0.2 µs per direction (bench/compact_sky_benchmark). Immutable, for several threads.
class CompactSkyModel final : public SkyModel {
 public:
  /// @param info  its domain; turbidity in aod500
  CompactSkyModel(ModelInfo info, compact::Tables tables);
  ~CompactSkyModel() override;

  /// @throws InputError  naming the key
  static std::unique_ptr<const SkyModel> read(const ModelInfo& info, const JsonReader& model);

  const ModelInfo& info() const override { return info_; }

  /// The sky has spectra if the model has wavelengths.
  std::unique_ptr<const Sky> at(const SkyConditions& conditions) const override;

 private:
  ModelInfo info_;
  std::shared_ptr<const compact::Expansion> expansion_;
};

}  // namespace skylut
