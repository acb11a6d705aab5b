#pragma once

#include <optional>
#include <string>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/core/provenance.hpp"
#include "skylut/site/place.hpp"

namespace skylut {

/// An atmosphere in the words of whoever asks for it: names, files and numbers. The defaults are the
/// project's.
struct AtmosphereDescription {
  std::string profile = "ussa1976";        ///< a name that load_profile knows, or a TOML file
  std::string aerosol = "rural";           ///< a name that load_aerosol knows, or a TOML file
  std::optional<double> humidity_percent;  ///< that its particles have grown at, [0, 99]; default: its own
  std::string ground_albedo = "0.2";       ///< a number within 0-1, a name or a CSV file
  std::optional<double> ozone_du;          ///< these four as in AtmosphereOptions
  std::optional<double> no2_du;
  std::optional<double> water_cm;
  std::optional<double> surface_pressure_hPa;
  /// Gives gravity, the planet's radius and the height of the ground; default: standard gravity, 6371 km, sea
  /// level.
  std::optional<Place> place;
  /// Whether the air bends light, AtmosphereOptions.
  bool refraction = false;
};

/// Loads what a description names and builds the atmosphere: the one door through which the program's
/// commands get theirs. Costs some 0.05 s, the first time with an aerosol up to 2 s.
/// @throws InputError  naming what is unknown, broken or out of range
Atmosphere build_atmosphere(const Context& context, const AtmosphereDescription& description);

/// Puts everything an atmosphere is made of, and the files it was read from, into a provenance, as "profile"
/// and "air".
void describe_into(const Context& context, const Atmosphere& atmosphere, Provenance& provenance);

}  // namespace skylut
