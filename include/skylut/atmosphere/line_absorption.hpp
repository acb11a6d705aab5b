#pragma once

#include <array>
#include <vector>

#include "skylut/atmosphere/exponential_sum.hpp"

namespace skylut {

struct Context;

/// A band of lines: its transmittance after a scaled amount u (molecules/m²) of the gas is
/// T(u) = Σ weight exp(-coefficient u), where u = ∫ N (p / 1013.25 hPa)^n (273.15 K / T)^m ds: the lines are
/// the broader, and absorb the more, the denser the air.
struct LineBand {
  double pressure_exponent = 0.0;     ///< n
  double temperature_exponent = 0.0;  ///< m
  std::vector<Exponential> sum;       ///< coefficients in m²; one term of 0 where nothing absorbs
};

/// Absorption of one gas by lines too narrow to resolve: the distribution of its absorption coefficients
/// in every nm (k-distribution). A mean coefficient would be wrong: what a line has taken out, more gas
/// cannot take out again, so transmittance falls slower than exponentially. [docs/air.md §10]
class LineAbsorption {
 public:
  static constexpr std::size_t kCoefficients = 8;
  /// Parts of 1 nm that have a row's coefficients, weakest first.
  static constexpr std::array<double, kCoefficients> kWeights{0.20, 0.20, 0.20, 0.16, 0.11, 0.07, 0.04, 0.02};

  /// 1 nm centred on the wavelength.
  struct Row {
    double wavelength_nm;  ///< a whole number
    double pressure_exponent;
    double temperature_exponent;
    std::array<double, kCoefficients> coefficient_m2;
  };

  /// @param rows  ascending; wavelengths left out do not absorb
  explicit LineAbsorption(std::vector<Row> rows);

  /// The band centred on a wavelength: every nm by its overlap, the exponents weighted by absorption.
  /// @param band_nm  width, > 0
  LineBand band(double wavelength_nm, double band_nm) const;

 private:
  std::vector<Row> rows_;
};

/// Water vapour, 500-1000 nm: band model of LOWTRAN 7 (Pierluissi et al. 1989) above 560 nm. Sources in
/// profiles/spectra/water_lines.csv. Amount: the vapour's.
LineAbsorption load_water_lines(const Context& context);

/// Oxygen: γ (628 nm), B (687 nm) and A (760 nm) bands from a line-by-line calculation. Sources in
/// profiles/spectra/oxygen_lines.csv. Amount: the oxygen's.
LineAbsorption load_oxygen_lines(const Context& context);

}  // namespace skylut
