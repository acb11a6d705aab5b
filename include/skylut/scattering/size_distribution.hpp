#pragma once

#include <string>
#include <vector>

namespace skylut {

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

}  // namespace skylut
