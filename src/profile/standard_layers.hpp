#pragma once

#include <vector>

namespace skylut {

/// The numbers that define a standard atmosphere of linear temperature layers.
struct StandardLayers {
  double ground_temperature_K = 288.15;
  double ground_pressure_hPa = 1013.25;
  std::vector<double> base_geopotential_km;  ///< ascending, the first is 0
  std::vector<double> lapse_rate_K_per_km;   ///< of each layer, by geopotential altitude
  std::vector<double> upper_altitude_km;     ///< geometric, ascending; the first is where the layers end
  std::vector<double> upper_temperature_K;   ///< kinetic, linear in between
  std::vector<double> upper_molar_mass_g_per_mol;
};

struct StandardState {
  double temperature_K = 0.0;
  double pressure_hPa = 0.0;
};

/// Temperature and pressure at a geometric altitude [0, last upper altitude]: closed forms of the
/// hydrostatic equation in the layers (U.S. Standard Atmosphere 1976, eqs. 18, 23, 33a-b), Simpson's rule
/// above them (0.1 km steps: error below 1e-9).
StandardState standard_state(const StandardLayers& layers, double altitude_km);

}  // namespace skylut
