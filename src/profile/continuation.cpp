#include "continuation.hpp"

#include <cmath>

#include "skylut/core/domain.hpp"

namespace skylut {

namespace {

// Up to here lies most of the ozone: a profile that reaches it knows the rest by its own end.
constexpr double kMostOzoneBelow_km = 30.0;

// A lower end says little of what is further above.
constexpr double kMemory_km = 5.0;

// Scale of the standard's density at an altitude above a profile's end.
double joining(double ratio_at_end, double end_km, double altitude_km) {
  if (end_km >= kMostOzoneBelow_km) return ratio_at_end;
  const double above = (altitude_km - end_km) / kMemory_km;
  return above < 1.0 ? std::pow(ratio_at_end, 1.0 - above) : 1.0;
}

}  // namespace

void continue_to_top(Profile& profile, const Profile& standard) {
  const double end_km = profile.altitude_km.back();
  if (end_km >= domain::kAtmosphereTop_km) return;
  const double pressure_ratio = profile.pressure_hPa.back() / air_state(standard, end_km).pressure_hPa;
  const std::size_t end = profile.altitude_km.size();
  for (std::size_t i = 0; i < standard.altitude_km.size(); ++i) {
    if (standard.altitude_km[i] <= end_km) continue;
    profile.altitude_km.push_back(standard.altitude_km[i]);
    profile.temperature_K.push_back(standard.temperature_K[i]);
    profile.pressure_hPa.push_back(pressure_ratio * standard.pressure_hPa[i]);
    if (!profile.relative_aerosol_extinction.empty()) profile.relative_aerosol_extinction.push_back(0.0);
  }
  const auto air_per_m3 = [&](std::size_t i) { return profile.pressure_hPa[i] / profile.temperature_K[i]; };
  for (GasProfile& gas : profile.gases) {
    const GasProfile& shape = *standard.gas(gas.name);
    const double last = gas.density_per_m3.back();
    const double ratio = last / interpolate_by_altitude(standard, shape.density_per_m3, end_km);
    const bool well_mixed = gas.name == "oxygen" || gas.name == "carbon_dioxide";
    for (std::size_t i = end; i < profile.altitude_km.size(); ++i) {
      const double z = profile.altitude_km[i];
      gas.density_per_m3.push_back(well_mixed
                                       ? last * air_per_m3(i) / air_per_m3(end - 1)
                                       : joining(ratio, end_km, z) *
                                             interpolate_by_altitude(standard, shape.density_per_m3, z));
    }
  }
}

}  // namespace skylut
