#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skylut/profile/report2005.hpp"

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

/// An atmosphere by altitude above its ground (level 0). Levels ascend and reach 100 km or more: a
/// file that ends lower (at 10 km above sea level or higher) is continued with the shape of the 1976
/// standard. The air weighs what its pressures say, see docs/air.md A54.
struct Profile {
  std::string name;
  std::string description;
  std::string source;
  std::string file;               ///< that it was read from; empty: none
  double described_top_km = 0.0;  ///< highest level of the file, above the ground; above it, continued
  /// Of the ground above sea level, if the file says it; without, the ground is at sea level unless a place
  /// says otherwise.
  std::optional<double> ground_height_km;

  std::vector<double> altitude_km;  ///< ascending, the first is 0, the last >= 100
  std::vector<double> temperature_K;
  std::vector<double> pressure_hPa;
  std::vector<GasProfile> gases;  ///< always ozone, oxygen and carbon_dioxide; others if given
  /// Aerosol extinction by level, any unit; empty: the aerosol's own vertical shape.
  std::vector<double> relative_aerosol_extinction;

  std::vector<ProfileColumn> columns;     ///< as read, described levels only
  std::optional<Report2005> report_2005;  ///< what the report prints of its own profile

  /// What was done to the file's numbers that its author may not expect, one sentence each; for warnings and
  /// provenance. Empty for the profiles that come with skylut.
  std::vector<std::string> notes;

  /// The gas of that name, or nullptr.
  const GasProfile* gas(std::string_view gas_name) const;
};

/// Reads a profile that comes with skylut by name (one of profile_names()), or a TOML file if the text
/// ends in .toml or holds a '/'. Format: docs/air.md.
/// @throws InputError  one line naming file (and line), key, value and what would be right: unknown
///                     name, broken TOML, unknown key or unit, missing column, NaN, duplicate
///                     altitude, negative density, top below 10 km, pressures that ask for air twice or
///                     half as warm as the temperatures
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

/// Scales a gas of the profile to a column above the ground.
/// @throws InputError  for a gas the profile does not hold, or a column that is negative or not finite
void scale_gas_column(Profile& profile, std::string_view gas_name, double column_per_m2);

/// Gives the profile another pressure at the ground: pressure and the well-mixed gases (oxygen, carbon
/// dioxide) are scaled by the same factor at every level. Temperature and the other gases stay as they are.
/// @throws InputError  for a pressure that is not positive and finite
void scale_surface_pressure(Profile& profile, double pressure_hPa);

/// The part of an atmosphere above a height of it, as an atmosphere whose ground is there: what lies above a
/// mountain. Levels count from the new ground, temperature, pressure and gases there are those between the
/// levels, gases keep the columns they have above that height; 100 km are reached as before. Below its own
/// ground (a depression) the lowest piece goes on with its lapse rate. Says so in the notes; 0 changes
/// nothing.
/// @param ground_km  of the new ground above the profile's own, domain::kGroundHeight_m
/// @throws InputError  for a height out of range
Profile raised_to(const Profile& profile, double ground_km);

/// Molecules/m² in a precipitable water of 1 cm (1 g/cm²): N_A / 18.01528 g/mol.
double water_molecules_per_m2_cm();

}  // namespace skylut
