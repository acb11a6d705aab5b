#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/profile/profile.hpp"
#include "standard_layers.hpp"

namespace skylut {

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
  std::vector<double> altitude_km;     ///< above sea level, where the file says the ground's height
  std::optional<double>
      ground_height_km;               ///< above sea level: ground_m, or the lowest level if that is not 0
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
