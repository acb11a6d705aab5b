#include "skylut/models/closed_form_sun.hpp"

#include <array>
#include <cmath>

#include "skylut/atmosphere/spectral_curve.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/csv.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

constexpr std::array<const char*, 5> kNames{"rayleigh", "ozone", "mixed_gases", "water_vapour", "aerosol"};

double kasten1966(double zenith_deg) {
  return 1.0 / (std::cos(zenith_deg * kRadiansPerDegree) + 0.15 * std::pow(93.885 - zenith_deg, -1.253));
}

// Gueymard 1994, FSEC-PF-270-94, as the report's closing paper prints it; docs/errata.md E16.
double gueymard1994(double zenith_deg, double a, double b, double c) {
  return 1.0 / (std::cos(zenith_deg * kRadiansPerDegree) + a * zenith_deg * std::pow(b - zenith_deg, -c));
}

// Beyond the last wavelength of the source, 993.5 nm, its value.
double value_of(const SpectralCurve& curve, double wavelength_nm) {
  return curve.at(std::min(wavelength_nm, curve.last_nm()));
}

double column_above_per_m2(const Profile& profile, const char* gas, double altitude_km) {
  const GasProfile* const density = profile.gas(gas);
  return density ? gas_column_per_m2(profile, *density, altitude_km, profile.altitude_km.back()) : 0.0;
}

double aerosol_depth(const Atmosphere& air, double wavelength_nm, double aod500, double altitude_km) {
  for (const ConstituentDepth& constituent :
       air.optical_depths({.wavelength_nm = wavelength_nm}, aod500, altitude_km))
    if (constituent.name == "aerosol") return constituent.depth;
  return 0.0;
}

// Ångström's law through the aerosol's optical depths at 500 and 1000 nm.
ClosedFormAir closed_form_air(const Atmosphere& air, double aod500, double altitude_km) {
  const Profile& profile = air.profile();
  ClosedFormAir result;
  result.ozone_atm_cm = 1e-3 * column_above_per_m2(profile, "ozone", altitude_km) / kDobsonUnit_per_m2;
  result.water_cm = column_above_per_m2(profile, "water_vapour", altitude_km) / water_molecules_per_m2_cm();
  result.angstrom_beta = aerosol_depth(air, 1000.0, aod500, altitude_km);
  if (result.angstrom_beta > 0.0)
    result.angstrom_exponent =
        std::log2(aerosol_depth(air, 500.0, aod500, altitude_km) / result.angstrom_beta);
  return result;
}

}  // namespace

ClosedFormAbsorption ClosedFormAbsorption::load(const Context& context) {
  const std::string path = context.data_file("spectra/closed_form_absorption.csv").string();
  const auto curve = [&](const char* column) { return read_spectral_curve(path, column, 0.0, 1e3); };
  return {curve("ozone_per_atm_cm"), curve("mixed_gases"), curve("water_vapour_per_cm")};
}

ClosedFormModel parse_closed_form_model(const std::string& text) {
  if (text == "iqbal") return ClosedFormModel::iqbal;
  if (text == "smarts-like") return ClosedFormModel::smarts_like;
  throw InputError("--model '{}': must be shells, iqbal or smarts-like", text);
}

OpticalMasses optical_masses(ClosedFormModel model, double zenith_deg, double pressure_hPa) {
  if (!(zenith_deg >= 0.0 && zenith_deg <= 90.0))
    throw InputError("sun zenith angle {} deg: must lie within 0 to 90 deg in a closed form", zenith_deg);
  if (!(pressure_hPa >= 0.0 && pressure_hPa <= 1100.0))
    throw InputError("pressure {} hPa: must lie within 0 to 1100 hPa", pressure_hPa);
  const double pressure = pressure_hPa / kStandardPressure_hPa;
  if (model == ClosedFormModel::iqbal) {
    const double mass = kasten1966(zenith_deg);
    return {mass * pressure, mass * pressure, mass, mass * pressure, mass};
  }
  const double air = pressure * gueymard1994(zenith_deg, 1.76759e-3, 94.37515, 1.21563);
  const double ozone = gueymard1994(zenith_deg, 1.07489e-2, 96.62667, 1.3882);
  const double water = gueymard1994(zenith_deg, 4.29452e-4, 92.24849, 1.2529);  // and haze, as low as it
  return {air, water, ozone, air, water};
}

std::vector<double> closed_form_transmittances(const ClosedFormAbsorption& absorption,
                                               const ClosedFormAir& air, const OpticalMasses& masses,
                                               double wavelength_nm) {
  const double wavelength_um = 1e-3 * wavelength_nm;
  const double gases = value_of(absorption.mixed_gases, wavelength_nm) * masses.mixed_gases;
  const double water =
      value_of(absorption.water_vapour_per_cm, wavelength_nm) * air.water_cm * masses.water_vapour;
  return {std::exp(-0.008735 * std::pow(wavelength_um, -4.08) * masses.rayleigh),
          std::exp(-value_of(absorption.ozone_per_atm_cm, wavelength_nm) * air.ozone_atm_cm * masses.ozone),
          std::exp(-1.41 * gases / std::pow(1.0 + 118.3 * gases, 0.45)),
          std::exp(-0.2385 * water / std::pow(1.0 + 20.07 * water, 0.45)),
          std::exp(-air.angstrom_beta * std::pow(wavelength_um, -air.angstrom_exponent) * masses.aerosol)};
}

SunIrradiance simulate_sun_closed_form(const Context& context, const SkyScene& scene, ClosedFormModel model) {
  require_one_of_each(scene);
  const Atmosphere& air = *scene.atmosphere;
  const double altitude_km = scene.altitudes_km[0];
  const ClosedFormAir columns = closed_form_air(air, to_aod500(scene.turbidities[0], air), altitude_km);
  const OpticalMasses masses =
      optical_masses(model, scene.suns[0].zenith_deg, air_state(air.profile(), altitude_km).pressure_hPa);
  SunIrradiance result;
  result.wavelengths = scene.wavelengths;
  result.sun = scene.suns[0];
  result.seen_sun = result.sun;
  result.beam_arrives = true;
  result.extraterrestrial = extraterrestrial_irradiance(context, scene);
  result.luminous_weight = luminous_weights(context, scene.wavelengths);
  const ClosedFormAbsorption absorption = ClosedFormAbsorption::load(context);
  for (const char* name : kNames) result.transmittance.push_back({name, {}});
  for (std::size_t i = 0; i < scene.wavelengths.size(); ++i) {
    double irradiance = result.extraterrestrial[i];
    const std::vector<double> transmittances =
        closed_form_transmittances(absorption, columns, masses, scene.wavelengths[i]);
    for (std::size_t k = 0; k < transmittances.size(); ++k) {
      result.transmittance[k].band_mean.push_back(transmittances[k]);
      irradiance *= transmittances[k];
    }
    result.direct_normal.push_back(irradiance);
  }
  return result;
}

}  // namespace skylut
