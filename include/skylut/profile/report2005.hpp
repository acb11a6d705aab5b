#pragma once

#include <string>
#include <vector>

/// What the UTM report 2005 §3.3.1 tabulates of an atmosphere, beside what light meets of it.
namespace skylut {

struct Profile;

/// What the report's own profile adds to temperature and pressure: eq. 3.12's constants and printed columns.
struct Report2005 {
  double ground_ozone_atm_cm = 0.0;
  double ozone_decrease_per_km = 0.0;
  std::vector<double> printed_altitude_km;
  std::vector<double> printed_relative_humidity_percent;
  std::vector<double> printed_precipitable_water_cm;
};

/// One level of the report's Table 3.1.
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

struct LevelTable {
  std::vector<LevelQuantities> levels;  ///< the described ones, from the ground up
  std::string source;                   ///< how the quantities were obtained
};

/// Table 3.1's quantities at the described levels of any profile. Of the report's own: T_eo by eq. 3.7, ozone
/// by eq. 3.12, humidity and water as printed. Of all others, integrals of the profile: T_eo is the mean
/// temperature of the ozone above the level, relative humidity the vapour's pressure over eq. 3.9, water and
/// ozone the columns above. Oxygen and carbon dioxide paths by eq. 3.11.
LevelTable level_quantities(const Profile& profile);

}  // namespace skylut
