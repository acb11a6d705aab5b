#pragma once

#include <string>
#include <vector>

#include "skylut/atmosphere/spectral_curve.hpp"

namespace skylut {

struct Context;

/// Extraterrestrial solar irradiance at the mean Earth-Sun distance. Its mean over any band is exact.
/// [docs/air.md §9]
class SolarSpectrum {
 public:
  /// A spectrum that comes with skylut (profiles/spectra/solar_*.csv, 1 nm band means), or a file of one's
  /// own.
  ///   astm-g173     ASTM G-173-03 extraterrestrial (Gueymard 2004), 280.5-1030.5 nm; the default
  ///   gueymard2003  Gueymard 2003/2004, 359.5-830.5 nm
  ///   kurucz1992    Kurucz 1992, 359.5-830.5 nm
  ///   a file        ends in .csv or has a slash: columns wavelength_nm, irradiance_W_m2_nm; straight lines
  ///                 between its points
  /// @throws InputError  for an unknown name (naming those there are) or a file that is none
  static SolarSpectrum load(const Context& context, const std::string& name_or_file = "astm-g173");

  /// The names that load() knows, the default first.
  static std::vector<std::string> names();

  /// The file that it was read from; empty: none.
  const std::string& file() const { return file_; }

  /// @param centre_nm  ascending, equally spaced; the bands touch
  /// @param mean_W_m2_nm  one per centre, > 0
  /// @throws InputError  for fewer than two bands, unequal steps or a value that is not positive
  SolarSpectrum(const std::vector<double>& centre_nm, const std::vector<double>& mean_W_m2_nm);

  /// Mean irradiance over [wavelength - band/2, wavelength + band/2], W m⁻² nm⁻¹.
  /// @throws InputError  for a band that is not positive or leaves the spectrum
  double irradiance_W_m2_nm(double wavelength_nm, double band_nm) const;

  /// Irradiance between two wavelengths, W/m². @throws InputError if they leave the spectrum.
  double integral_W_m2(double lower_nm, double upper_nm) const;

 private:
  explicit SolarSpectrum(SpectralCurve curve) : curve_(std::move(curve)) {}

  SpectralCurve curve_;
  std::string file_;
};

}  // namespace skylut
