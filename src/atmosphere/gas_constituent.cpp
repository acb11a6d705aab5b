#include "gas_constituent.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace skylut {

GasConstituent::GasConstituent(std::shared_ptr<const Profile> profile, AbsorbingGas gas)
    : profile_(std::move(profile)), gas_(std::move(gas)) {}

void GasConstituent::set_levels(const std::vector<double>& levels_km) {
  nodes_ = gas_nodes_by_layer(*profile_, gas_.gas_name, gas_.pairs, levels_km);
}

double GasConstituent::depth_of(const std::vector<ColumnNode>& nodes, double wavelength_nm) const {
  double depth = 0.0;
  for (const ColumnNode& node : nodes)
    depth += node.column_per_m2 * gas_.cross_section.at_m2(wavelength_nm, node.temperature_K);
  return depth;
}

std::vector<ExtinctionTerm> GasConstituent::extinction(const Band& band, double, BandTerms) const {
  ExtinctionTerm term;
  for (const std::vector<ColumnNode>& layer : nodes_)
    term.depth.push_back(depth_of(layer, band.wavelength_nm));
  return {std::move(term)};
}

double GasConstituent::depth_above(const Band& band, double, double altitude_km) const {
  return depth_of(gas_nodes(*profile_, gas_.gas_name, gas_.pairs, altitude_km, profile_->altitude_km.back()),
                  band.wavelength_nm);
}

nlohmann::ordered_json GasConstituent::describe() const {
  return {{"name", gas_.name}, {"gas", gas_.gas_name}, {"pairs", gas_.pairs}};
}

}  // namespace skylut
