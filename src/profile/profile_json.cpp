#include "skylut/profile/profile_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace skylut {

nlohmann::ordered_json profile_json(const Profile& profile) {
  nlohmann::ordered_json gases = nlohmann::ordered_json::object();
  for (const GasProfile& gas : profile.gases) gases[gas.name] = gas.density_per_m3;
  return {{"name", profile.name},
          {"description", profile.description},
          {"source", profile.source},
          {"described_top_km", profile.described_top_km},
          {"altitude_km", profile.altitude_km},
          {"temperature_K", profile.temperature_K},
          {"pressure_hPa", profile.pressure_hPa},
          {"gas_density_per_m3", std::move(gases)},
          {"relative_aerosol_extinction", profile.relative_aerosol_extinction}};
}

}  // namespace skylut
