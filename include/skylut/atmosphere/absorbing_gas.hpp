#pragma once

#include <string>
#include <vector>

namespace skylut {

/// Absorption cross-section of a gas, quadratic in temperature at every wavelength:
/// σ(λ, T) = σ0 + σ1 t + σ2 t², t = T - reference, T held within the measured range, σ >= 0.
class CrossSection {
 public:
  /// The polynomial at one wavelength, m², m²/K, m²/K².
  struct Row {
    double wavelength_nm;
    double constant_m2;
    double linear_m2_K;
    double quadratic_m2_K2;
  };

  /// @param rows  at least two, ascending wavelengths
  CrossSection(std::vector<Row> rows, double reference_temperature_K, double lowest_K, double highest_K);

  /// m² per molecule (m⁵ for pairs); coefficients linear in wavelength between rows.
  /// @throws InputError  for a wavelength outside the rows
  double at_m2(double wavelength_nm, double temperature_K) const;

 private:
  std::vector<Row> rows_;
  double reference_temperature_K_;
  double lowest_K_;
  double highest_K_;
};

/// A gas that absorbs: which one of the profile, and how strongly. Atmosphere takes a list of them, so that a
/// new gas is a new entry.
struct AbsorbingGas {
  std::string name;      ///< of the constituent: "ozone", "no2", "o2_o2"
  std::string gas_name;  ///< as in Profile::gases; a profile without it has none of it
  CrossSection cross_section;
  bool pairs = false;  ///< absorbs by pairs of molecules: with the square of its density
};

}  // namespace skylut
