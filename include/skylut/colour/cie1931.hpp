#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/wavelength_grid.hpp"

namespace skylut {

struct Context;

/// Σ weight[i] spectrum[i] in double precision: tristimulus values from ColourMatching::weights.
/// @param spectrum  as long as the weights, of floats or doubles
template <class Number>
Xyz weighted_sum(std::span<const Xyz> weights, std::span<const Number> spectrum) {
  Xyz sum;
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const auto value = static_cast<double>(spectrum[i]);
    sum.X += weights[i].X * value;
    sum.Y += weights[i].Y * value;
    sum.Z += weights[i].Z * value;
  }
  return sum;
}

/// The CIE 1931 2° colour matching functions x̄, ȳ, z̄ at 5 nm steps, read from
/// profiles/spectra/cie1931_2deg.csv. [fit.md C1-C3]
class ColourMatching {
 public:
  /// Reads the table of the installation.
  /// @throws WorkError   if the file is missing
  /// @throws InputError  "file:line: …" if it does not hold what its header says
  static ColourMatching load(const Context& context);

  /// Tristimulus values of a spectrum: X = K_m ∫ L(λ) x̄(λ) dλ with K_m = 683.002 lm/W, and so on.
  ///
  /// The spectrum is taken as linear between its wavelengths, the colour matching functions as linear
  /// between the table's 5 nm steps, and the product is summed by the trapezoidal rule on the finer of
  /// the two grids (the union of both where neither divides the other). On the default grid, 5 nm, this
  /// is the plain CIE sum Σ L x̄ · 5 nm with half weight for the two ends. Beyond the grid the spectrum
  /// is taken as 0; 380-780 nm holds all but 6e-5 of ȳ.
  ///
  /// @param grid      one to 10001 wavelengths; a single wavelength is a line of the grid's step width
  /// @param radiance  W m⁻² sr⁻¹ nm⁻¹, one value per wavelength of the grid
  /// @return          X, Y, Z in cd/m²
  /// @throws InputError  if the sizes differ
  Xyz integrate(const WavelengthGrid& grid, std::span<const double> radiance_W_m2_sr_nm) const;

  /// The same as one weight per wavelength of the grid: X = Σ weight.X[i] L[i]. For many spectra on one grid.
  std::vector<Xyz> weights(const WavelengthGrid& grid) const;

  /// Part of ∫ V(λ) dλ, V = ȳ, that lies between two wavelengths, [0, 1]; to 1e-4. @param first_nm  <=
  /// last_nm
  double part_of_vision(double first_nm, double last_nm) const;

  /// x̄, ȳ, z̄ at one wavelength, linear between the table's; 0 outside it.
  Xyz at(double wavelength_nm) const;

  const std::vector<double>& wavelengths_nm() const { return wavelength_nm_; }
  const std::vector<Xyz>& values() const { return value_; }

  /// Whether light of chromaticity (x, y) can exist: inside or on the polygon of the spectral locus closed
  /// by the line of purples. [fit.md C5]
  bool inside_spectral_locus(double x, double y) const;

 private:
  std::vector<double> wavelength_nm_;
  std::vector<Xyz> value_;
  std::vector<Yxy> locus_;  // convex hull of the spectral chromaticities, counter-clockwise
};

}  // namespace skylut
