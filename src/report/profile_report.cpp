#include "skylut/report/profile_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

constexpr double kShown_nm = 550.0;

struct Column {
  std::string name;
  std::string unit;
  double value;
};

// Columns above the ground in the unit that the field uses for each gas.
std::vector<Column> gas_columns(const Profile& profile) {
  const double top_km = profile.altitude_km.back();
  std::vector<Column> columns{{"air", "molecules/m2", air_column_per_m2(profile, 0.0, top_km)}};
  for (const GasProfile& gas : profile.gases) {
    const double molecules = gas_column_per_m2(profile, gas, 0.0, top_km);
    if (gas.name == "ozone" || gas.name == "nitrogen_dioxide")
      columns.push_back({gas.name, "DU", molecules / kDobsonUnit_per_m2});
    else if (gas.name == "water_vapour")
      columns.push_back({gas.name, "cm", molecules / water_molecules_per_m2_cm()});
    else
      columns.push_back({gas.name, "molecules/m2", molecules});
  }
  return columns;
}

struct TurbidityValue {
  std::string name;
  double value;
};

std::vector<TurbidityValue> turbidity_values(const Atmosphere& air, double aod500) {
  std::vector<TurbidityValue> values;
  for (TurbidityKind kind : turbidity_kinds())
    values.push_back({std::string(turbidity_kind_name(kind)), from_aod500(aod500, kind, air)});
  values.push_back({"visibility-km-mcclatchey-selby",
                    mcclatchey_selby_visibility_km(from_aod500(aod500, TurbidityKind::angstrom_beta, air),
                                                   air.options().aerosol.angstrom_exponent)});
  return values;
}

// Optical depths of the constituents in one layer, by the difference of those above its ends.
std::vector<ConstituentDepth> layer_depths(const Atmosphere& air, double aod500, std::size_t layer) {
  const std::vector<double>& levels = air.shells().levels_km;
  std::vector<ConstituentDepth> depths =
      air.optical_depths({.wavelength_nm = kShown_nm}, aod500, levels[layer]);
  const std::vector<ConstituentDepth> above =
      air.optical_depths({.wavelength_nm = kShown_nm}, aod500, levels[layer + 1]);
  for (std::size_t i = 0; i < depths.size(); ++i) depths[i].depth -= above[i].depth;
  return depths;
}

double total_of(const std::vector<ConstituentDepth>& depths) {
  double total = 0.0;
  for (const ConstituentDepth& depth : depths) total += depth.depth;
  return total;
}

// A number, or the name of a curve.
ordered_json ground_json(const GroundAlbedo& ground) {
  if (const std::optional<double> number = ground.constant()) return *number;
  return ground.name();
}

std::string heading(const AtmosphereOptions& options, const Profile& profile) {
  const std::string continued =
      profile.described_top_km < profile.altitude_km.back()
          ? fmt::format(", continued to {:g} km with the 1976 standard's shape", profile.altitude_km.back())
          : "";
  return fmt::format(
      "{}: {}\n  source: {}\n  described to {:g} km{}\n"
      "  gravity {:.5f} m/s2, planet radius {:g} km, ground albedo {}\n",
      profile.name, profile.description, profile.source, profile.described_top_km, continued,
      options.gravity_m_s2, options.planet_radius_km, options.ground_albedo.text());
}

std::string quantities_table(const Profile& profile) {
  std::string text = fmt::format("\nQuantities of Table 3.1 ({})\n", profile.quantities_source);
  text += "    z/km    T/K     p/hPa  T_eo/K   RH/%   O2/km    CO2/km   H2O/cm  O3/atm-cm\n";
  for (const LevelQuantities& level : profile.quantities)
    text += fmt::format("  {:6g} {:6.2f} {:9.5g}  {:6.2f} {:6.2f} {:8.4f} {:8.4f} {:9.5f} {:8.4f}\n",
                        level.altitude_km, level.temperature_K, level.pressure_hPa, level.ozone_temperature_K,
                        level.relative_humidity_percent, level.oxygen_path_km, level.carbon_dioxide_path_km,
                        level.precipitable_water_cm, level.ozone_atm_cm);
  return text;
}

std::string levels_table(const Profile& profile) {
  std::string text = "\nLevels, densities in molecules/m3\n    z/km    T/K     p/hPa       air";
  for (const GasProfile& gas : profile.gases) text += fmt::format(" {:>16}", gas.name);
  if (!profile.relative_aerosol_extinction.empty()) text += "  aerosol";
  text += "\n";
  for (std::size_t i = 0; i < profile.altitude_km.size(); ++i) {
    text += fmt::format("  {:6g} {:6.2f} {:9.5g} {:9.3e}", profile.altitude_km[i], profile.temperature_K[i],
                        profile.pressure_hPa[i], air_state(profile, profile.altitude_km[i]).density_per_m3);
    for (const GasProfile& gas : profile.gases) text += fmt::format(" {:16.3e}", gas.density_per_m3[i]);
    if (!profile.relative_aerosol_extinction.empty())
      text += fmt::format(" {:8.3g}", profile.relative_aerosol_extinction[i]);
    text += "\n";
  }
  return text;
}

std::string depths_tables(const Atmosphere& air, double aod500) {
  const std::vector<ConstituentDepth> whole = air.optical_depths({.wavelength_nm = kShown_nm}, aod500);
  std::string text = fmt::format("\nOptical depth above the ground at {:g} nm\n", kShown_nm);
  for (const ConstituentDepth& depth : whole)
    text += fmt::format("  {:<18} {:.6f}\n", depth.name, depth.depth);
  text += fmt::format("  {:<18} {:.6f}\n", "total", total_of(whole));

  text += fmt::format("\nLayers, optical depth at {:g} nm\n   from/km    to/km", kShown_nm);
  for (const ConstituentDepth& depth : whole) text += fmt::format(" {:>12}", depth.name);
  text += "      total\n";
  const std::vector<double>& levels = air.shells().levels_km;
  for (std::size_t layer = 0; layer + 1 < levels.size(); ++layer) {
    const std::vector<ConstituentDepth> depths = layer_depths(air, aod500, layer);
    text += fmt::format("  {:8g} {:8g}", levels[layer], levels[layer + 1]);
    for (const ConstituentDepth& depth : depths) text += fmt::format(" {:12.3e}", depth.depth);
    text += fmt::format(" {:10.3e}\n", total_of(depths));
  }
  return text;
}

}  // namespace

std::string profile_text(const Atmosphere& air, double aod500) {
  const Profile& profile = air.profile();
  std::string text = heading(air.options(), profile);
  text += quantities_table(profile);
  text += levels_table(profile);
  text += "\nColumns above the ground\n";
  for (const Column& column : gas_columns(profile))
    text += fmt::format("  {:<18} {:.5g} {}\n", column.name, column.value, column.unit);
  text += depths_tables(air, aod500);
  text += "\nTurbidity\n";
  for (const TurbidityValue& turbidity : turbidity_values(air, aod500))
    text += fmt::format("  {:<32} {:.6g}\n", turbidity.name, turbidity.value);
  return text;
}

ordered_json profile_json(const Atmosphere& air, double aod500) {
  const Profile& profile = air.profile();
  ordered_json json{{"name", profile.name},
                    {"description", profile.description},
                    {"source", profile.source},
                    {"described_top_km", profile.described_top_km},
                    {"gravity_m_s2", air.options().gravity_m_s2},
                    {"planet_radius_km", air.options().planet_radius_km},
                    {"ground_albedo", ground_json(air.options().ground_albedo)}};

  ordered_json& written = json["columns"] = ordered_json::array();
  for (const ProfileColumn& column : profile.columns)
    written.push_back(
        {{"name", column.name}, {"unit", column.unit}, {"source", column.source}, {"values", column.values}});

  ordered_json& levels = json["levels"];
  levels["altitude_km"] = profile.altitude_km;
  levels["temperature_K"] = profile.temperature_K;
  levels["pressure_hPa"] = profile.pressure_hPa;
  std::vector<double> air_per_m3;
  for (double z : profile.altitude_km) air_per_m3.push_back(air_state(profile, z).density_per_m3);
  levels["air_per_m3"] = air_per_m3;
  for (const GasProfile& gas : profile.gases) levels[gas.name + "_per_m3"] = gas.density_per_m3;
  if (!profile.relative_aerosol_extinction.empty())
    levels["relative_aerosol_extinction"] = profile.relative_aerosol_extinction;

  ordered_json& table = json["table_3_1"];
  table["source"] = profile.quantities_source;
  for (const LevelQuantities& level : profile.quantities)
    table["levels"].push_back({{"altitude_km", level.altitude_km},
                               {"temperature_K", level.temperature_K},
                               {"pressure_hPa", level.pressure_hPa},
                               {"ozone_temperature_K", level.ozone_temperature_K},
                               {"relative_humidity_percent", level.relative_humidity_percent},
                               {"oxygen_path_km", level.oxygen_path_km},
                               {"carbon_dioxide_path_km", level.carbon_dioxide_path_km},
                               {"precipitable_water_cm", level.precipitable_water_cm},
                               {"ozone_atm_cm", level.ozone_atm_cm}});

  for (const Column& column : gas_columns(profile))
    json["columns_above_ground"][column.name] = {{"value", column.value}, {"unit", column.unit}};

  const std::vector<ConstituentDepth> whole = air.optical_depths({.wavelength_nm = kShown_nm}, aod500);
  ordered_json& depths = json["optical_depths"];
  depths["wavelength_nm"] = kShown_nm;
  for (const ConstituentDepth& depth : whole) depths[depth.name] = depth.depth;
  depths["total"] = total_of(whole);

  ordered_json& layers = json["layers"];
  layers["levels_km"] = air.shells().levels_km;
  layers["wavelength_nm"] = kShown_nm;
  for (std::size_t layer = 0; layer + 1 < air.shells().levels_km.size(); ++layer)
    for (const ConstituentDepth& depth : layer_depths(air, aod500, layer))
      layers[depth.name].push_back(depth.depth);

  for (const TurbidityValue& turbidity : turbidity_values(air, aod500))
    json["turbidity"][turbidity.name] = turbidity.value;
  return json;
}

}  // namespace skylut
