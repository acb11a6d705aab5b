#include "skylut/profile/profile.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

constexpr double kMetresPerKm = 1000.0;
constexpr double kPascalPerHectopascal = 100.0;

// The piece [i, i+1] of the levels that holds an altitude.
std::size_t piece_at(const Profile& profile, double altitude_km) {
  const std::vector<double>& levels = profile.altitude_km;
  if (!(altitude_km >= levels.front() && altitude_km <= levels.back()))
    throw InputError("altitude {} km: must lie within {}-{} km of profile {}", altitude_km, levels.front(),
                     levels.back(), profile.name);
  return piece_of(levels, altitude_km);
}

double interpolate_in_piece(const Profile& profile, const std::vector<double>& by_level, std::size_t i,
                            double z) {
  const double part = (z - profile.altitude_km[i]) / (profile.altitude_km[i + 1] - profile.altitude_km[i]);
  return log_linear_or_linear(by_level[i], by_level[i + 1], part);
}

// Calls visit(i, from, to) for every piece of the levels between two altitudes.
template <typename Visit>
void for_each_piece(const Profile& profile, double lower_km, double upper_km, Visit visit) {
  if (!(lower_km <= upper_km))
    throw InputError("altitudes {} to {} km: the first must not exceed the second", lower_km, upper_km);
  const std::size_t last = piece_at(profile, upper_km);
  for (std::size_t i = piece_at(profile, lower_km); i <= last; ++i)
    visit(i, std::max(lower_km, profile.altitude_km[i]), std::min(upper_km, profile.altitude_km[i + 1]));
}

}  // namespace

const GasProfile* Profile::gas(std::string_view gas_name) const {
  for (const GasProfile& gas : gases)
    if (gas.name == gas_name) return &gas;
  return nullptr;
}

AirState air_state(const Profile& profile, double altitude_km) {
  const std::size_t i = piece_at(profile, altitude_km);
  const double part =
      (altitude_km - profile.altitude_km[i]) / (profile.altitude_km[i + 1] - profile.altitude_km[i]);
  const double lower_K = profile.temperature_K[i];
  const double upper_K = profile.temperature_K[i + 1];
  const double pressure_step = std::log(profile.pressure_hPa[i + 1] / profile.pressure_hPa[i]);

  AirState state;
  state.temperature_K = linear(lower_K, upper_K, part);
  // ln(T/T_i) / ln(T_j/T_i) tends to `part` where the two temperatures meet.
  const double warming = std::log(upper_K / lower_K);
  const double exponent = std::abs(warming) < 1e-9 ? part : std::log(state.temperature_K / lower_K) / warming;
  state.pressure_hPa = profile.pressure_hPa[i] * std::exp(pressure_step * exponent);
  state.density_per_m3 =
      kPascalPerHectopascal * state.pressure_hPa / (kBoltzmann_J_per_K * state.temperature_K);
  return state;
}

double interpolate_by_altitude(const Profile& profile, const std::vector<double>& by_level,
                               double altitude_km) {
  return interpolate_in_piece(profile, by_level, piece_at(profile, altitude_km), altitude_km);
}

double gas_column_per_m2(const Profile& profile, const GasProfile& gas, double lower_km, double upper_km) {
  double column = 0.0;
  for_each_piece(profile, lower_km, upper_km, [&](std::size_t i, double from, double to) {
    const double bottom = interpolate_in_piece(profile, gas.density_per_m3, i, from);
    const double top = interpolate_in_piece(profile, gas.density_per_m3, i, to);
    // ∫ of an exponential: (n_b - n_t) Δz / ln(n_b/n_t); the mean where the two meet or the piece is linear.
    const bool exponential = gas.density_per_m3[i] > 0.0 && gas.density_per_m3[i + 1] > 0.0;
    const double logarithm = exponential ? std::log(bottom / top) : 0.0;
    const double mean = std::abs(logarithm) > 1e-4 ? (bottom - top) / logarithm : 0.5 * (bottom + top);
    column += mean * (to - from) * kMetresPerKm;
  });
  return column;
}

double air_column_per_m2(const Profile& profile, double lower_km, double upper_km) {
  static const Quadrature rule = gauss_legendre(8, 0.0, 1.0);
  double column = 0.0;
  for_each_piece(profile, lower_km, upper_km, [&](std::size_t, double from, double to) {
    for (std::size_t k = 0; k < rule.node.size(); ++k)
      column += rule.weight[k] * (to - from) * kMetresPerKm *
                air_state(profile, from + rule.node[k] * (to - from)).density_per_m3;
  });
  return column;
}

void scale_gas_column(Profile& profile, std::string_view gas_name, double column_per_m2) {
  if (!(column_per_m2 >= 0.0) || !std::isfinite(column_per_m2))
    throw InputError("{} column {} molecules/m2: must be finite and not negative", gas_name, column_per_m2);
  for (GasProfile& gas : profile.gases) {
    if (gas.name != gas_name) continue;
    const double present =
        gas_column_per_m2(profile, gas, profile.altitude_km.front(), profile.altitude_km.back());
    if (present <= 0.0) break;
    for (double& density : gas.density_per_m3) density *= column_per_m2 / present;
    return;
  }
  throw InputError("{} column {} molecules/m2: profile {} holds no {} to scale", gas_name, column_per_m2,
                   profile.name, gas_name);
}

void scale_surface_pressure(Profile& profile, double pressure_hPa) {
  if (!(pressure_hPa > 0.0) || !std::isfinite(pressure_hPa))
    throw InputError("surface pressure {} hPa: must be finite and greater than 0", pressure_hPa);
  const double factor = pressure_hPa / profile.pressure_hPa.front();
  for (double& pressure : profile.pressure_hPa) pressure *= factor;
  for (GasProfile& gas : profile.gases)
    if (gas.name == "oxygen" || gas.name == "carbon_dioxide")
      for (double& density : gas.density_per_m3) density *= factor;
}

}  // namespace skylut
