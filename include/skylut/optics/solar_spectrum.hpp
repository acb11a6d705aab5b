#pragma once

#include <vector>

namespace skylut {

/// Extraterrestrial solar irradiance at the mean Earth-Sun distance, held as means over adjacent bands.
class SolarSpectrum {
 public:
  /// The spectrum that comes with skylut: ASTM G-173-03 extraterrestrial, 5 nm band means centred on
  /// 300, 305, … 1000 nm (profiles/spectra/solar_astm_g173.csv).
  static SolarSpectrum load_default();

  /// @param centre_nm  ascending, equally spaced; the bands touch
  /// @param mean_W_m2_nm  one per centre, > 0
  /// @throws InputError  for fewer than two bands, unequal steps or a value that is not positive
  SolarSpectrum(std::vector<double> centre_nm, std::vector<double> mean_W_m2_nm);

  /// Mean irradiance over [wavelength - band/2, wavelength + band/2], W m⁻² nm⁻¹: exact on the table's
  /// own bands, otherwise weighted by overlap.
  /// @throws InputError  for a band that is not positive or leaves the spectrum
  double irradiance_W_m2_nm(double wavelength_nm, double band_nm) const;

  /// Irradiance between two wavelengths, W/m². @throws InputError if they leave the spectrum.
  double integral_W_m2(double lower_nm, double upper_nm) const;

 private:
  std::vector<double> mean_W_m2_nm_;
  std::vector<double> cumulative_W_m2_;  // at the band edges
  double first_edge_nm_;
  double step_nm_;
};

}  // namespace skylut
