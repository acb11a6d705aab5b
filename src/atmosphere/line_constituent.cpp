#include "line_constituent.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace skylut {

namespace {

double scaled_amount_per_m2(const LineBand& band, const std::vector<ColumnNode>& nodes) {
  double amount = 0.0;
  for (const ColumnNode& node : nodes)
    amount += node.column_per_m2 * std::exp(band.pressure_exponent * node.log_pressure +
                                            band.temperature_exponent * node.log_inverse_temperature);
  return amount;
}

}  // namespace

LineConstituent::LineConstituent(std::shared_ptr<const Profile> profile, std::string gas_name,
                                 LineAbsorption lines)
    : profile_(std::move(profile)), gas_name_(std::move(gas_name)), lines_(std::move(lines)) {}

void LineConstituent::set_levels(const std::vector<double>& levels_km) {
  nodes_ = gas_nodes_by_layer(*profile_, gas_name_, false, levels_km);
}

std::vector<ExtinctionTerm> LineConstituent::extinction(const Band& band, double, BandTerms which) const {
  const LineBand line_band = lines_.band(band.wavelength_nm, band.width_nm);
  std::vector<double> amounts_per_m2;
  double whole_per_m2 = 0.0;
  for (const std::vector<ColumnNode>& layer : nodes_) {
    amounts_per_m2.push_back(line_band.sum.size() > 1 ? scaled_amount_per_m2(line_band, layer) : 0.0);
    whole_per_m2 += amounts_per_m2.back();
  }
  std::vector<ExtinctionTerm> terms;
  for (const Exponential& exponential :
       which == BandTerms::few ? fit_exponentials(line_band.sum, whole_per_m2) : line_band.sum) {
    terms.push_back({exponential.weight, amounts_per_m2});
    for (double& depth : terms.back().depth) depth *= exponential.coefficient;
  }
  return terms;
}

double LineConstituent::depth_above(const Band& band, double, double altitude_km) const {
  const LineBand line_band = lines_.band(band.wavelength_nm, band.width_nm);
  const double amount = scaled_amount_per_m2(
      line_band, gas_nodes(*profile_, gas_name_, false, altitude_km, profile_->altitude_km.back()));
  return std::max(0.0, -std::log(transmittance(line_band.sum, amount)));
}

nlohmann::ordered_json LineConstituent::describe() const {
  return {{"name", gas_name_}, {"gas", gas_name_}, {"lines", true}};
}

}  // namespace skylut
