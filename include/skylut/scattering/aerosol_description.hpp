#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/scattering/aerosol_shape.hpp"

namespace skylut {

struct Context;

/// How many particles have which radius, by number.
struct SizeDistribution {
  enum class Kind {
    lognormal,  ///< dN/d ln r ∝ exp(-ln²(r/r_mode) / (2 ln² σ_g)), one particle over all radii
    power_law,  ///< Junge: dN/d ln r ∝ r^-ν, one particle between the limits
  };
  Kind kind = Kind::lognormal;
  double mode_radius_um = 0.1;  ///< lognormal: r_mode of the number distribution
  double sigma_g = 2.0;         ///< lognormal: geometric standard deviation, > 1
  double exponent = 3.0;        ///< power law: ν = -d ln N / d ln r of dN/d ln r (dN/dr ∝ r^-(ν+1))
  double r_min_um = 0.005;      ///< no particles outside the limits
  double r_max_um = 20.0;

  /// dN/d ln r at a radius; 0 outside the limits.
  double per_log_radius(double radius_um) const;
};

/// Particles of one substance.
struct AerosolComponent {
  std::string name;
  std::string source;
  std::string file;             ///< of its own that it was read from; empty: none
  double number_per_cm3 = 1.0;  ///< relative to the other components
  SizeDistribution size;
  std::vector<double> wavelength_nm;  ///< ascending
  std::vector<double> n;  ///< refractive index n + i k, linear between the wavelengths, held beyond
  std::vector<double> k;  ///< >= 0
};

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
