#pragma once

#include <memory>
#include <string>
#include <vector>

#include "air_column.hpp"
#include "skylut/atmosphere/constituent.hpp"
#include "skylut/atmosphere/line_absorption.hpp"

namespace skylut {

/// A gas that absorbs by lines too narrow to resolve: several terms to a band. Different gases' lines are
/// independent: their transmittances multiply. [docs/air.md §10]
class LineConstituent final : public Constituent {
 public:
  LineConstituent(std::shared_ptr<const Profile> profile, std::string gas_name, LineAbsorption lines);

  std::string name() const override { return gas_name_; }
  bool is_smooth() const override { return false; }
  void set_levels(const std::vector<double>& levels_km) override;
  std::vector<ExtinctionTerm> extinction(const Band& band, double aod500, BandTerms terms) const override;
  double depth_above(const Band& band, double aod500, double altitude_km) const override;
  nlohmann::ordered_json describe() const override;

 private:
  std::shared_ptr<const Profile> profile_;
  std::string gas_name_;
  LineAbsorption lines_;
  std::vector<std::vector<ColumnNode>> nodes_;  // by layer
};

}  // namespace skylut
