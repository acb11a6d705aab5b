#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "continuation.hpp"
#include "ground_level.hpp"
#include "hydrostatic.hpp"
#include "profile_file.hpp"
#include "report2005.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"
#include "skylut/profile/profile.hpp"

namespace skylut {

namespace {

constexpr const char* kStandardName = "ussa1976";

// Dry, well-mixed air where a file does not say: U.S. Standard Atmosphere 1976 table 3 for oxygen;
// carbon dioxide as Bodhaine et al. 1999 take it for their published optical depths.
constexpr double kOxygenFraction = 0.209476;
constexpr double kCarbonDioxideFraction = 360e-6;

void set_temperature_and_pressure(const Context& context, const ProfileFile& file, const std::string& path,
                                  Profile& profile) {
  profile.temperature_K = file.temperature_K;
  profile.pressure_hPa = file.pressure_hPa;
  if (file.standard_layers)
    for (double z : file.altitude_km) {
      const StandardState state = standard_state(*file.standard_layers, z);
      profile.temperature_K.push_back(state.temperature_K);
      profile.pressure_hPa.push_back(state.pressure_hPa);
    }
  if (!file.temperature_and_pressure_of.empty()) {
    const std::vector<std::string> names = profile_names(context);
    if (std::find(names.begin(), names.end(), file.temperature_and_pressure_of) == names.end() ||
        file.temperature_and_pressure_of == file.name)
      throw InputError("{}: temperature_and_pressure_of = '{}': must be another of {}", path,
                       file.temperature_and_pressure_of, fmt::join(names, ", "));
    const Profile other = load_profile(context, file.temperature_and_pressure_of);
    if (file.altitude_km.back() > other.altitude_km.back())
      throw InputError("{}: column.altitude.values reach {} km: must end with {} at {} km or below", path,
                       file.altitude_km.back(), other.name, other.altitude_km.back());
    for (double z : file.altitude_km) {
      const AirState state = air_state(other, z);
      profile.temperature_K.push_back(state.temperature_K);
      profile.pressure_hPa.push_back(state.pressure_hPa);
    }
  }
}

double air_density_per_m3(const Profile& profile, std::size_t level) {
  return 100.0 * profile.pressure_hPa[level] / (kBoltzmann_J_per_K * profile.temperature_K[level]);
}

void set_gases(const ProfileFile& file, Profile& profile) {
  profile.gases = file.gases;
  for (GasProfile& gas : profile.gases) {
    const auto& ratios = file.mixing_ratio_gases;
    if (std::find(ratios.begin(), ratios.end(), gas.name) == ratios.end()) continue;
    for (std::size_t i = 0; i < gas.density_per_m3.size(); ++i)
      gas.density_per_m3[i] *= air_density_per_m3(profile, i);
  }
  const auto well_mixed = [&](const char* name, double fraction) {
    if (profile.gas(name) != nullptr) return;
    GasProfile gas{name, {}};
    for (std::size_t i = 0; i < profile.altitude_km.size(); ++i)
      gas.density_per_m3.push_back(fraction * air_density_per_m3(profile, i));
    profile.gases.push_back(std::move(gas));
  };
  well_mixed("oxygen", kOxygenFraction);
  well_mixed("carbon_dioxide", kCarbonDioxideFraction);
}

// Ozone of eq. 3.12 (a constant density up to the end of the report's profile) and water vapour as the
// slope of the printed precipitable water.
void add_report_gases(const Report2005& report, Profile& profile) {
  const std::vector<LevelQuantities> levels = report_quantities(profile, report);
  GasProfile ozone{"ozone", {}};
  GasProfile water{"water_vapour", {}};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    ozone.density_per_m3.push_back(report.ground_ozone_atm_cm * report.ozone_decrease_per_km *
                                   kDobsonUnit_per_m2);
    const LevelQuantities& below = levels[i == 0 ? 0 : i - 1];
    const LevelQuantities& above = levels[std::min(i + 1, levels.size() - 1)];
    const double decrease_per_km = std::log(below.precipitable_water_cm / above.precipitable_water_cm) /
                                   (above.altitude_km - below.altitude_km);
    water.density_per_m3.push_back(1e-3 * decrease_per_km * levels[i].precipitable_water_cm *
                                   water_molecules_per_m2_cm());
  }
  profile.gases.insert(profile.gases.begin(), {std::move(ozone), std::move(water)});
}

// Scales the ozone above the described levels until its column there is the one eq. 3.12 leaves over.
// The piece above the last level mixes both logarithmically, hence the iteration (monotonic).
void set_ozone_above(Profile& profile, double column_per_m2) {
  auto ozone = std::find_if(profile.gases.begin(), profile.gases.end(),
                            [](const auto& g) { return g.name == "ozone"; });
  for (int pass = 0; pass < 100; ++pass) {
    const double ratio = column_per_m2 / gas_column_per_m2(profile, *ozone, profile.described_top_km,
                                                           profile.altitude_km.back());
    for (std::size_t i = 0; i < profile.altitude_km.size(); ++i)
      if (profile.altitude_km[i] > profile.described_top_km) ozone->density_per_m3[i] *= ratio;
    if (std::abs(ratio - 1.0) < 1e-12) return;
  }
}

void scale_totals(const TotalColumns& total, const std::string& path, Profile& profile) {
  const auto scale = [&](const char* key, const std::optional<double>& value, const char* gas_name,
                         double per_m2) {
    if (!value) return;
    const GasProfile* gas = profile.gas(gas_name);
    if (gas == nullptr || *std::max_element(gas->density_per_m3.begin(), gas->density_per_m3.end()) <= 0.0)
      throw InputError("{}: total.{} = {}: there is no {} to scale; give it a column that is not all 0", path,
                       key, *value, gas_name);
    scale_gas_column(profile, gas_name, *value * per_m2);
  };
  scale("ozone_du", total.ozone_du, "ozone", kDobsonUnit_per_m2);
  scale("nitrogen_dioxide_du", total.nitrogen_dioxide_du, "nitrogen_dioxide", kDobsonUnit_per_m2);
  scale("water_vapour_cm", total.water_vapour_cm, "water_vapour", water_molecules_per_m2_cm());
}

std::string file_of(const Context& context, const std::string& name_or_path) {
  const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
  if (is_path) {
    if (!std::filesystem::is_regular_file(name_or_path) && !std::filesystem::is_fifo(name_or_path))
      throw InputError("profile '{}': no such file", name_or_path);
    return name_or_path;
  }
  const std::vector<std::string> names = profile_names(context);
  if (std::find(names.begin(), names.end(), name_or_path) == names.end())
    throw InputError("profile '{}': must be one of {}, or a .toml file{}", name_or_path,
                     fmt::join(names, ", "), suggested(name_or_path, names));
  return context.data_file(name_or_path + ".toml").string();
}

}  // namespace

Profile load_profile(const Context& context, const std::string& name_or_path) {
  const std::string path = file_of(context, name_or_path);
  const ProfileFile file = read_profile_file(path);
  Profile profile;
  profile.name = file.name;
  profile.description = file.description;
  profile.source = file.source;
  profile.file = path;
  profile.altitude_km = file.altitude_km;
  profile.described_top_km = file.altitude_km.back();
  profile.columns = file.columns;
  profile.relative_aerosol_extinction = file.relative_aerosol_extinction;
  set_temperature_and_pressure(context, file, path, profile);
  set_gases(file, profile);
  if (file.report_2005) add_report_gases(*file.report_2005, profile);
  if (profile.altitude_km.back() < domain::kAtmosphereTop_km)
    continue_to_top(profile, load_profile(context, kStandardName));
  if (file.report_2005) {
    profile.report_2005 = file.report_2005;
    set_ozone_above(profile, report_quantities(profile, *file.report_2005).back().ozone_atm_cm * 1000.0 *
                                 kDobsonUnit_per_m2);
  }
  std::vector<std::string> by_mixing_ratio = file.mixing_ratio_gases;
  for (const char* name : {"oxygen", "carbon_dioxide"})
    if (std::none_of(file.gases.begin(), file.gases.end(), [&](const auto& gas) { return gas.name == name; }))
      by_mixing_ratio.emplace_back(name);
  balance(profile, 0.0, by_mixing_ratio, path);
  if (file.ground_height_km) {
    if (*file.ground_height_km != 0.0) profile = with_ground_at(profile, *file.ground_height_km);
    profile.ground_height_km = file.ground_height_km;
  }
  scale_totals(file.total, path, profile);
  return profile;
}

std::vector<std::string> profile_names(const Context& context) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(context.data_folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace skylut
