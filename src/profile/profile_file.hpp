#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/profile/profile.hpp"
#include "standard_layers.hpp"

namespace skylut {

/// What the UTM report 2005 §3.3.1 adds to temperature and pressure.
struct Report2005 {
  double ground_ozone_atm_cm = 0.0;
  double ozone_decrease_per_km = 0.0;
  std::vector<double> printed_altitude_km;
  std::vector<double> printed_relative_humidity_percent;
  std::vector<double> printed_precipitable_water_cm;
};

/// Total columns that the gases are scaled to.
struct TotalColumns {
  std::optional<double> ozone_du;
  std::optional<double> nitrogen_dioxide_du;
  std::optional<double> water_vapour_cm;
};

/// A profile file as it stands, checked by itself: levels sorted, values finite and in range. Exactly one
/// of temperature and pressure columns, standard layers, or another profile's name is present.
struct ProfileFile {
  std::string name;
  std::string description;
  std::string source;
  std::vector<ProfileColumn> columns;  ///< as written, sorted by altitude
  std::vector<double> altitude_km;
  std::vector<double> temperature_K;  ///< empty unless given as columns; likewise pressure
  std::vector<double> pressure_hPa;
  std::vector<GasProfile> gases;                ///< in m⁻³ …
  std::vector<std::string> mixing_ratio_gases;  ///< … except these, which are still mole fractions
  std::vector<double> relative_aerosol_extinction;
  std::optional<StandardLayers> standard_layers;
  std::string temperature_and_pressure_of;
  TotalColumns total;
  std::optional<Report2005> report_2005;
};

/// Reads and checks a profile file. @throws InputError  one line naming file, line, key, value and what
/// would be right
ProfileFile read_profile_file(const std::string& file);

}  // namespace skylut
