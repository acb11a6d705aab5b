#include "ground_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

namespace {

constexpr double kSameLevel_km = 1e-6;

// Through two levels; constant where one of them is 0.
double beyond(double lower, double upper, double part) {
  return lower > 0.0 && upper > 0.0 ? log_linear(lower, upper, part) : lower;
}

// The lowest piece continued downwards: the same lapse rate, the same law of pressure.
void add_level_below(Profile& profile, double altitude_km) {
  const double part =
      (altitude_km - profile.altitude_km[0]) / (profile.altitude_km[1] - profile.altitude_km[0]);
  const double lower_K = profile.temperature_K[0];
  const double upper_K = profile.temperature_K[1];
  const double temperature_K = linear(lower_K, upper_K, part);
  const double warming = std::log(upper_K / lower_K);
  const double exponent = std::abs(warming) < 1e-9 ? part : std::log(temperature_K / lower_K) / warming;
  const auto put = [](std::vector<double>& values, double value) { values.insert(values.begin(), value); };
  put(profile.pressure_hPa, beyond(profile.pressure_hPa[0], profile.pressure_hPa[1], exponent));
  put(profile.temperature_K, temperature_K);
  for (GasProfile& gas : profile.gases)
    put(gas.density_per_m3, beyond(gas.density_per_m3[0], gas.density_per_m3[1], part));
  if (!profile.relative_aerosol_extinction.empty())
    put(profile.relative_aerosol_extinction, profile.relative_aerosol_extinction[0]);
  put(profile.altitude_km, altitude_km);
}

// Isothermal air of one composition above the last level.
void add_level_above(Profile& profile, double altitude_km) {
  const std::size_t last = profile.altitude_km.size() - 1;
  const double thickness_km = profile.altitude_km[last] - profile.altitude_km[last - 1];
  const double ratio = std::pow(profile.pressure_hPa[last] / profile.pressure_hPa[last - 1],
                                (altitude_km - profile.altitude_km[last]) / thickness_km);
  profile.altitude_km.push_back(altitude_km);
  profile.temperature_K.push_back(profile.temperature_K[last]);
  profile.pressure_hPa.push_back(ratio * profile.pressure_hPa[last]);
  for (GasProfile& gas : profile.gases) gas.density_per_m3.push_back(ratio * gas.density_per_m3[last]);
  if (!profile.relative_aerosol_extinction.empty()) profile.relative_aerosol_extinction.push_back(0.0);
}

}  // namespace

Profile with_ground_at(const Profile& profile, double altitude_km) {
  Profile result = profile;
  const auto first = std::find_if(profile.altitude_km.begin(), profile.altitude_km.end(),
                                  [&](double z) { return z > altitude_km - kSameLevel_km; });
  if (altitude_km < profile.altitude_km.front() - kSameLevel_km) {
    add_level_below(result, altitude_km);
  } else {
    const auto keep = first - profile.altitude_km.begin();
    const auto drop = [&](std::vector<double>& values) {
      if (!values.empty()) values.erase(values.begin(), values.begin() + keep);
    };
    for (std::vector<double>* values : {&result.altitude_km, &result.temperature_K, &result.pressure_hPa,
                                        &result.relative_aerosol_extinction})
      drop(*values);
    for (GasProfile& gas : result.gases) drop(gas.density_per_m3);
    if (std::abs(*first - altitude_km) > kSameLevel_km) {
      const AirState ground = air_state(profile, altitude_km);
      const auto put = [](std::vector<double>& values, double value) {
        values.insert(values.begin(), value);
      };
      put(result.altitude_km, altitude_km);
      put(result.temperature_K, ground.temperature_K);
      put(result.pressure_hPa, ground.pressure_hPa);
      for (std::size_t g = 0; g < result.gases.size(); ++g)
        put(result.gases[g].density_per_m3,
            interpolate_by_altitude(profile, profile.gases[g].density_per_m3, altitude_km));
      if (!profile.relative_aerosol_extinction.empty())
        put(result.relative_aerosol_extinction,
            interpolate_by_altitude(profile, profile.relative_aerosol_extinction, altitude_km));
    }
  }
  for (double& z : result.altitude_km) z -= altitude_km;
  result.altitude_km.front() = 0.0;
  if (result.altitude_km.back() < domain::kAtmosphereTop_km)
    add_level_above(result, domain::kAtmosphereTop_km);
  result.described_top_km = std::max(0.0, profile.described_top_km - altitude_km);
  result.report_2005.reset();
  const std::vector<double>& aerosol = result.relative_aerosol_extinction;
  if (!aerosol.empty() && *std::max_element(aerosol.begin(), aerosol.end()) <= 0.0) {
    result.relative_aerosol_extinction.clear();
    result.notes.push_back(
        "no aerosol of the profile lies above the ground: the aerosol's own shape is used");
  }
  return result;
}

Profile raised_to(const Profile& profile, double ground_km) {
  require_within("ground height above the profile's", 1000.0 * ground_km, domain::kGroundHeight_m);
  if (ground_km == 0.0) return profile;
  Profile result = with_ground_at(profile, ground_km);
  result.ground_height_km = profile.ground_height_km.value_or(0.0) + ground_km;
  result.notes.push_back(
      fmt::format("the ground at {:g} m above sea level: {}, {:.6g} hPa and {:.5g} K there",
                  1000.0 * *result.ground_height_km,
                  ground_km > 0.0 ? "the air above that height" : "the air continued down to that height",
                  result.pressure_hPa.front(), result.temperature_K.front()));
  return result;
}

}  // namespace skylut
