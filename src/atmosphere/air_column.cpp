#include "air_column.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

// Reference state of the amounts in LineBand.
constexpr double kLineTemperature_K = 273.15;
constexpr double kMetresPerKm = 1000.0;

}  // namespace

std::vector<ColumnNode> gas_nodes(const Profile& profile, const std::string& gas_name, bool pairs,
                                  double lower_km, double upper_km) {
  const GasProfile* gas = profile.gas(gas_name);
  if (gas == nullptr) return {};
  const Quadrature rule = gauss_legendre(6, 0.0, 1.0);
  std::vector<double> edges{lower_km};
  for (const double z : profile.altitude_km)
    if (z > lower_km && z < upper_km) edges.push_back(z);
  edges.push_back(upper_km);
  std::vector<ColumnNode> nodes;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const double thickness_km = edges[i + 1] - edges[i];
      const double z = edges[i] + rule.node[k] * thickness_km;
      const AirState state = air_state(profile, z);
      const double density_per_m3 = interpolate_by_altitude(profile, gas->density_per_m3, z);
      nodes.push_back({.temperature_K = state.temperature_K,
                       .column_per_m2 = kMetresPerKm * thickness_km * rule.weight[k] * density_per_m3 *
                                        (pairs ? density_per_m3 : 1.0),
                       .log_pressure = std::log(state.pressure_hPa / kStandardPressure_hPa),
                       .log_inverse_temperature = std::log(kLineTemperature_K / state.temperature_K)});
    }
  return nodes;
}

std::vector<std::vector<ColumnNode>> gas_nodes_by_layer(const Profile& profile, const std::string& gas_name,
                                                        bool pairs, const std::vector<double>& levels_km) {
  std::vector<std::vector<ColumnNode>> nodes;
  for (std::size_t layer = 0; layer + 1 < levels_km.size(); ++layer)
    nodes.push_back(gas_nodes(profile, gas_name, pairs, levels_km[layer], levels_km[layer + 1]));
  return nodes;
}

double stretched_air_per_m2(const Profile& profile, double gravity_m_s2, double lower_km, double upper_km) {
  const double stretch = gravity_m_s2 / kStandardGravity_m_s2;
  const double top_km = profile.altitude_km.back();
  return air_column_per_m2(profile, std::min(lower_km * stretch, top_km),
                           std::min(upper_km * stretch, top_km)) /
         stretch;
}

}  // namespace skylut
