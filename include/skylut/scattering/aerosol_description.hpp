#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/scattering/aerosol_shape.hpp"
#include "skylut/scattering/size_distribution.hpp"

namespace skylut {

struct Context;

/// Optical properties as given, without particles: extinction by Ångström's law, Henyey-Greenstein.
struct GivenOptics {
  double angstrom_exponent = 1.3;
  std::vector<double> wavelength_nm;
  std::vector<double> single_scattering_albedo;
  std::vector<double> asymmetry;
};

/// An aerosol as its file describes it: particles or given optics, and where they are.
struct AerosolDescription {
  std::string name;
  std::string description;
  std::string source;
  std::string file;                          ///< that it was read from; empty: none
  std::optional<double> humidity_percent;    ///< of components that take up water
  std::vector<AerosolComponent> components;  ///< mixed externally; or …
  std::optional<GivenOptics> optics;         ///< … this
  AerosolShape shape;
  std::string shape_source;
  std::string stratosphere;  ///< name of the aerosol of the stratospheric layer; empty: the same
};

/// Reads an aerosol that comes with skylut by name ("rural", …), or a TOML file if the text ends in
/// .toml or holds a '/'. Format: docs/aerosols.md.
/// @param humidity_percent  0-99, instead of the file's own
/// @throws InputError  one line naming file (and line), key, value and what would be right; or a
///                     humidity given for an aerosol that takes up no water
AerosolDescription load_aerosol_description(const Context& context, const std::string& name_or_path,
                                            std::optional<double> humidity_percent = std::nullopt);

/// Names of the aerosols that come with skylut, sorted.
std::vector<std::string> aerosol_names(const Context& context);

}  // namespace skylut
