#include "standard_layers.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

namespace {

// U.S. Standard Atmosphere 1976, table 2: the constants that go with its layers (its gas constant is
// older than SI 2019's by design).
constexpr double kGasConstant_J_per_kmol_K = 8314.32;
constexpr double kMolarMass_g_per_mol = 28.9644;
constexpr double kEffectiveEarthRadius_km = 6356.766;

// Hydrostatic constant M g0 / R, K per geopotential km.
constexpr double hydrostatic_K_per_km(double molar_mass_g_per_mol) {
  return 1000.0 * kStandardGravity_m_s2 * molar_mass_g_per_mol / kGasConstant_J_per_kmol_K;
}

// Eq. 18: H = r0 z / (r0 + z).
double geopotential_km(double altitude_km) {
  return kEffectiveEarthRadius_km * altitude_km / (kEffectiveEarthRadius_km + altitude_km);
}

StandardState state_in_layers(const StandardLayers& layers, double geopotential) {
  StandardState state{layers.ground_temperature_K, layers.ground_pressure_hPa};
  for (std::size_t i = 0; i < layers.base_geopotential_km.size(); ++i) {
    const double base = layers.base_geopotential_km[i];
    if (i > 0 && base >= geopotential) break;
    const bool last = i + 1 == layers.base_geopotential_km.size();
    const double top = last ? geopotential : std::min(geopotential, layers.base_geopotential_km[i + 1]);
    const double lapse = layers.lapse_rate_K_per_km[i];
    const double constant = hydrostatic_K_per_km(kMolarMass_g_per_mol);
    const double warmer = state.temperature_K + lapse * (top - base);
    if (lapse == 0.0)
      state.pressure_hPa *= std::exp(-constant * (top - base) / state.temperature_K);  // eq. 33b
    else
      state.pressure_hPa *= std::pow(state.temperature_K / warmer, constant / lapse);  // eq. 33a
    state.temperature_K = warmer;
  }
  return state;
}

double at_altitude(const std::vector<double>& altitude_km, const std::vector<double>& value, double z) {
  const std::size_t i = piece_of(altitude_km, z);
  return linear(value[i], value[i + 1], (z - altitude_km[i]) / (altitude_km[i + 1] - altitude_km[i]));
}

}  // namespace

StandardState standard_state(const StandardLayers& layers, double altitude_km) {
  const double layers_top_km = layers.upper_altitude_km.front();
  if (altitude_km < layers_top_km) return state_in_layers(layers, geopotential_km(altitude_km));

  // d ln p / dz = -M g0 (r0/(r0+z))² / (R T)
  const auto slope = [&](double z) {
    const double gravity_ratio = std::pow(kEffectiveEarthRadius_km / (kEffectiveEarthRadius_km + z), 2);
    return -hydrostatic_K_per_km(
               at_altitude(layers.upper_altitude_km, layers.upper_molar_mass_g_per_mol, z)) *
           gravity_ratio / at_altitude(layers.upper_altitude_km, layers.upper_temperature_K, z);
  };
  const auto steps = static_cast<int>(std::ceil((altitude_km - layers_top_km) / 0.1));
  double logarithm = std::log(state_in_layers(layers, geopotential_km(layers_top_km)).pressure_hPa);
  for (int i = 0; i < steps; ++i) {
    const double step = (altitude_km - layers_top_km) / steps;
    const double z = layers_top_km + i * step;
    logarithm += step / 6.0 * (slope(z) + 4.0 * slope(z + 0.5 * step) + slope(z + step));
  }
  return {at_altitude(layers.upper_altitude_km, layers.upper_temperature_K, altitude_km),
          std::exp(logarithm)};
}

}  // namespace skylut
