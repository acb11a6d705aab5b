#include "continuation.hpp"

namespace skylut {

void continue_to_top(Profile& profile, const Profile& standard) {
  const double end_km = profile.altitude_km.back();
  if (end_km >= kAtmosphereTop_km) return;
  const double pressure_ratio = profile.pressure_hPa.back() / air_state(standard, end_km).pressure_hPa;
  const std::size_t end = profile.altitude_km.size();
  for (std::size_t i = 0; i < standard.altitude_km.size(); ++i) {
    if (standard.altitude_km[i] <= end_km) continue;
    profile.altitude_km.push_back(standard.altitude_km[i]);
    profile.temperature_K.push_back(standard.temperature_K[i]);
    profile.pressure_hPa.push_back(pressure_ratio * standard.pressure_hPa[i]);
    if (!profile.relative_aerosol_extinction.empty()) profile.relative_aerosol_extinction.push_back(0.0);
  }
  for (GasProfile& gas : profile.gases) {
    const GasProfile& shape = *standard.gas(gas.name);
    const double ratio =
        gas.density_per_m3.back() / interpolate_by_altitude(standard, shape.density_per_m3, end_km);
    for (std::size_t i = end; i < profile.altitude_km.size(); ++i)
      gas.density_per_m3.push_back(
          ratio * interpolate_by_altitude(standard, shape.density_per_m3, profile.altitude_km[i]));
  }
}

}  // namespace skylut
