#pragma once

#include <string>
#include <vector>

#include "skylut/profile/profile.hpp"

namespace skylut {

/// Molecules of a gas in one state of the air: a node of the integral over a layer.
struct ColumnNode {
  double temperature_K;
  double column_per_m2;            ///< per m⁵ for pairs of molecules
  double log_pressure;             ///< ln(p / 1013.25 hPa)
  double log_inverse_temperature;  ///< ln(273.15 K / T)
};

/// Nodes of a gas between two altitudes: six of Gauss and Legendre in every piece of the profile.
/// @param pairs  with the square of the density
/// @return       none if the profile holds no such gas
std::vector<ColumnNode> gas_nodes(const Profile& profile, const std::string& gas_name, bool pairs,
                                  double lower_km, double upper_km);

/// The same for every layer between levels.
std::vector<std::vector<ColumnNode>> gas_nodes_by_layer(const Profile& profile, const std::string& gas_name,
                                                        bool pairs, const std::vector<double>& levels_km);

/// Molecules of air per m² between two altitudes under a gravity that is not the standard's: the air at
/// altitude z is that of the profile at z g/g0, so that its column is p/(m g). [docs/air.md §6]
double stretched_air_per_m2(const Profile& profile, double gravity_m_s2, double lower_km, double upper_km);

}  // namespace skylut
