#pragma once

#include <memory>
#include <vector>

#include "air_column.hpp"
#include "skylut/atmosphere/absorbing_gas.hpp"
#include "skylut/atmosphere/constituent.hpp"

namespace skylut {

/// A gas that absorbs smoothly, by itself or by pairs of its molecules. A profile without it holds none.
class GasConstituent final : public Constituent {
 public:
  GasConstituent(std::shared_ptr<const Profile> profile, AbsorbingGas gas);

  std::string name() const override { return gas_.name; }
  void set_levels(const std::vector<double>& levels_km) override;
  std::vector<ExtinctionTerm> extinction(const Band& band, double aod500, BandTerms terms) const override;
  double depth_above(const Band& band, double aod500, double altitude_km) const override;
  nlohmann::ordered_json describe() const override;

 private:
  double depth_of(const std::vector<ColumnNode>& nodes, double wavelength_nm) const;

  std::shared_ptr<const Profile> profile_;
  AbsorbingGas gas_;
  std::vector<std::vector<ColumnNode>> nodes_;  // by layer
};

}  // namespace skylut
