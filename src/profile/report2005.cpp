#include "report2005.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/interpolation.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

namespace {

constexpr double kWaterMolarMass_g_per_mol = 18.01528;
constexpr double kCelsiusZero_K = 273.15;

// Eq. 3.11 (Gueymard 1995): u = c0 (p/p0)^c1 (288.15/T)^c2, a path in km that carries the pressure and
// temperature dependence of the band absorption.
struct ScaledPath {
  double c0_km;
  double c1;
  double c2;
  double at(double pressure_hPa, double temperature_K) const {
    return c0_km * std::pow(pressure_hPa / 1013.25, c1) * std::pow(288.15 / temperature_K, c2);
  }
};
constexpr ScaledPath kOxygenPath{4.9293, 1.8849, 0.1815};
constexpr ScaledPath kCarbonDioxidePath{4.8649, 1.9908, -0.697};

// Eq. 3.9: saturation vapour pressure over water, hPa.
double saturation_vapour_pressure_hPa(double temperature_K) {
  const double celsius = temperature_K - kCelsiusZero_K;
  return 6.11 * std::pow(10.0, 7.5 * celsius / (237.7 + celsius));
}

LevelQuantities state_and_paths(const Profile& profile, std::size_t level) {
  LevelQuantities quantities;
  quantities.altitude_km = profile.altitude_km[level];
  quantities.temperature_K = profile.temperature_K[level];
  quantities.pressure_hPa = profile.pressure_hPa[level];
  quantities.oxygen_path_km = kOxygenPath.at(quantities.pressure_hPa, quantities.temperature_K);
  quantities.carbon_dioxide_path_km =
      kCarbonDioxidePath.at(quantities.pressure_hPa, quantities.temperature_K);
  return quantities;
}

double mean_ozone_temperature_K(const Profile& profile, const GasProfile& ozone, std::size_t level) {
  const Quadrature rule = gauss_legendre(4, 0.0, 1.0);
  double molecules = 0.0;
  double weighted = 0.0;
  for (std::size_t i = level; i + 1 < profile.altitude_km.size(); ++i) {
    const double thickness = profile.altitude_km[i + 1] - profile.altitude_km[i];
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const double z = profile.altitude_km[i] + rule.node[k] * thickness;
      const double amount =
          rule.weight[k] * thickness * interpolate_by_altitude(profile, ozone.density_per_m3, z);
      molecules += amount;
      weighted += amount * air_state(profile, z).temperature_K;
    }
  }
  return molecules > 0.0 ? weighted / molecules : profile.temperature_K[level];
}

// Logarithm linear in altitude between the printed levels, beyond them continued.
double between_printed(const std::vector<double>& altitude_km, const std::vector<double>& value, double z) {
  const std::size_t i = piece_of(altitude_km, z);
  return log_linear(value[i], value[i + 1], (z - altitude_km[i]) / (altitude_km[i + 1] - altitude_km[i]));
}

}  // namespace

double water_molecules_per_m2_cm() { return 1e4 * kAvogadro_per_mol / kWaterMolarMass_g_per_mol; }

namespace {

std::vector<LevelQuantities> physical_quantities(const Profile& profile) {
  const GasProfile& ozone = *profile.gas("ozone");
  const GasProfile* water = profile.gas("water_vapour");
  const double top_km = profile.altitude_km.back();
  std::vector<LevelQuantities> levels;
  for (std::size_t i = 0;
       i < profile.altitude_km.size() && profile.altitude_km[i] <= profile.described_top_km; ++i) {
    LevelQuantities quantities = state_and_paths(profile, i);
    quantities.ozone_temperature_K = mean_ozone_temperature_K(profile, ozone, i);
    quantities.ozone_atm_cm =
        gas_column_per_m2(profile, ozone, quantities.altitude_km, top_km) / (1000.0 * kDobsonUnit_per_m2);
    if (water != nullptr) {
      const double vapour_pressure_hPa =
          0.01 * water->density_per_m3[i] * kBoltzmann_J_per_K * quantities.temperature_K;
      quantities.relative_humidity_percent =
          100.0 * vapour_pressure_hPa / saturation_vapour_pressure_hPa(quantities.temperature_K);
      quantities.precipitable_water_cm =
          gas_column_per_m2(profile, *water, quantities.altitude_km, top_km) / water_molecules_per_m2_cm();
    }
    levels.push_back(quantities);
  }
  return levels;
}

}  // namespace

LevelTable level_quantities(const Profile& profile) {
  if (profile.report_2005)
    return {report_quantities(profile, *profile.report_2005),
            "UTM report 2005, eqs. 3.7, 3.11, 3.12; humidity and water as printed in its Table 3.1"};
  return {physical_quantities(profile),
          "integrals of the profile; oxygen and carbon dioxide paths by UTM report 2005 eq. 3.11"};
}

std::vector<LevelQuantities> report_quantities(const Profile& profile, const Report2005& report) {
  std::vector<LevelQuantities> levels;
  for (std::size_t i = 0;
       i < profile.altitude_km.size() && profile.altitude_km[i] <= profile.described_top_km; ++i) {
    LevelQuantities quantities = state_and_paths(profile, i);
    const double z = quantities.altitude_km;
    quantities.ozone_temperature_K = 142.68 + 0.28498 * quantities.temperature_K;  // eq. 3.7
    quantities.ozone_atm_cm =
        report.ground_ozone_atm_cm * (1.0 - report.ozone_decrease_per_km * z);  // eq. 3.12
    quantities.relative_humidity_percent =
        between_printed(report.printed_altitude_km, report.printed_relative_humidity_percent, z);
    quantities.precipitable_water_cm =
        between_printed(report.printed_altitude_km, report.printed_precipitable_water_cm, z);
    levels.push_back(quantities);
  }
  return levels;
}

}  // namespace skylut
