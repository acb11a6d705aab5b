#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace skylut {

struct Context;

/// One data column of a profile file as it was read: what it is, in which unit, and from where.
struct ProfileColumn {
  std::string name;            ///< key in the file: altitude, temperature, ozone, …
  std::string unit;            ///< as written in the file
  std::string source;          ///< as written in the file
  std::vector<double> values;  ///< in that unit, in ascending order of altitude
};

/// Number density of one gas by level.
struct GasProfile {
  std::string name;                    ///< ozone, water_vapour, nitrogen_dioxide, oxygen, carbon_dioxide
  std::vector<double> density_per_m3;  ///< molecules/m³, one per level, >= 0
};

/// One level of the report's Table 3.1 (UTM report 2005 §3.3.1).
struct LevelQuantities {
  double altitude_km = 0.0;
  double temperature_K = 0.0;
  double pressure_hPa = 0.0;
  double ozone_temperature_K = 0.0;  ///< effective ozone temperature T_eo
  double relative_humidity_percent = 0.0;
  double oxygen_path_km = 0.0;  ///< scaled path length u_g, eq. 3.11
  double carbon_dioxide_path_km = 0.0;
  double precipitable_water_cm = 0.0;  ///< above the level
  double ozone_atm_cm = 0.0;           ///< above the level; 1000 DU = 1 atm-cm
};

/// An atmosphere by altitude above its ground (level 0). Levels ascend and reach 100 km or more: a
/// file that ends lower (at 30 km or above) is continued with the shape of the 1976 standard.
struct Profile {
  std::string name;
  std::string description;
  std::string source;
  std::string file;               ///< that it was read from; empty: none
  double described_top_km = 0.0;  ///< highest level of the file; above it, continued

  std::vector<double> altitude_km;  ///< ascending, the first is 0, the last >= 100
  std::vector<double> temperature_K;
  std::vector<double> pressure_hPa;
  std::vector<GasProfile> gases;  ///< always ozone, oxygen and carbon_dioxide; others if given
  /// Aerosol extinction by level, any unit; empty: the aerosol's own vertical shape.
  std::vector<double> relative_aerosol_extinction;

  std::vector<ProfileColumn> columns;       ///< as read, described levels only
  std::vector<LevelQuantities> quantities;  ///< Table 3.1's, at the described levels
  std::string quantities_source;            ///< how they were obtained
  bool quantities_printed = false;          ///< by a report, hence not what the levels hold

  /// The gas of that name, or nullptr.
  const GasProfile* gas(std::string_view gas_name) const;
};

/// Reads a profile that comes with skylut by name ("ussa1976", "utm2005"), or a TOML file if the text
/// ends in .toml or holds a '/'. Format: docs/air.md.
/// @throws InputError  one line naming file (and line), key, value and what would be right: unknown
///                     name, broken TOML, unknown key or unit, missing column, NaN, duplicate
///                     altitude, negative density, first level not 0, top below 30 km
Profile load_profile(const Context& context, const std::string& name_or_path);

/// Names of the profiles that come with skylut, sorted.
std::vector<std::string> profile_names(const Context& context);

/// Temperature, pressure and number density of the air at one altitude.
struct AirState {
  double temperature_K = 0.0;
  double pressure_hPa = 0.0;
  double density_per_m3 = 0.0;  ///< p / (k T)
};

/// State of the air between levels: temperature linear, pressure as in hydrostatic air of that lapse
/// rate, p = p_i (T/T_i)^(ln(p_j/p_i) / ln(T_j/T_i)) (exponential where T_i = T_j).
/// @param altitude_km  in [0, last level]
/// @throws InputError  for an altitude outside the profile
AirState air_state(const Profile& profile, double altitude_km);

/// Values given by level at one altitude: logarithm linear in altitude (linear where a neighbour is 0).
/// @param by_level  one value >= 0 per level
/// @throws InputError  for an altitude outside the profile
double interpolate_by_altitude(const Profile& profile, const std::vector<double>& by_level,
                               double altitude_km);

/// Molecules/m² of a gas between two altitudes, 0 <= lower <= upper <= last level; relative accuracy
/// 1e-9 of the interpolated profile (closed form of the exponential pieces).
double gas_column_per_m2(const Profile& profile, const GasProfile& gas, double lower_km, double upper_km);

/// Molecules/m² of air between two altitudes; Gauss-Legendre on every piece, relative accuracy 1e-9.
double air_column_per_m2(const Profile& profile, double lower_km, double upper_km);

/// The same profile with a gas scaled to a column above the ground.
/// @throws InputError  for a gas the profile does not hold, or a column that is negative or not finite
void scale_gas_column(Profile& profile, std::string_view gas_name, double column_per_m2);

/// The same profile with another pressure at the ground: pressure and the well-mixed gases (oxygen, carbon
/// dioxide) by the same factor at every level. Temperature and the other gases stay as they are.
/// @throws InputError  for a pressure that is not positive and finite
void scale_surface_pressure(Profile& profile, double pressure_hPa);

/// Table 3.1's quantities anew, after gases or pressure were scaled; those printed by a report stay.
void update_quantities(Profile& profile);

/// Molecules/m² in a precipitable water of 1 cm (1 g/cm²): N_A / 18.01528 g/mol.
double water_molecules_per_m2_cm();

}  // namespace skylut
