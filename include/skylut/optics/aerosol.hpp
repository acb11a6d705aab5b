#pragma once

#include <memory>
#include <vector>

#include "skylut/optics/phase_function.hpp"

namespace skylut {

/// Where an aerosol is: haze near the ground, thinning exponentially, under a thin stratospheric layer
/// whose optical depth does not follow the haze. [docs/air.md §7]
struct AerosolShape {
  /// Scale height of the haze, km. Rural haze of Shettle and Fenn 1979 thins by e in 2.1 km.
  double haze_scale_height_km = 2.0;
  /// Optical depth of the stratospheric layer at 500 nm: quiet years without large eruptions hold
  /// 0.004-0.006. A smaller load than this is stratospheric altogether.
  double stratospheric_aod500 = 0.005;
  double stratospheric_centre_km = 19.0;  ///< altitude of its maximum; Gaussian
  double stratospheric_width_km = 4.0;    ///< its standard deviation

  /// Part of the optical depth between two altitudes, of an atmosphere that ends at top_km; 1 over all.
  double part_between(double lower_km, double upper_km, double top_km, double aod500) const;

  /// Its derivative: extinction at one altitude per unit of optical depth, 1/km.
  double density_per_km(double altitude_km, double top_km, double aod500) const;
};

/// What aerosol does to light, per unit of optical depth. The default is rural aerosol.
struct AerosolOptics {
  /// τ(λ) = τ(500 nm) (λ / 500 nm)^-α. 1.3: Ångström's value for average haze.
  double angstrom_exponent = 1.3;

  /// Single-scattering albedo and asymmetry by wavelength, linear in between, held constant beyond the
  /// ends. Rural aerosol at 70 % relative humidity of Shettle and Fenn 1979 (AFGL-TR-79-0214).
  std::vector<double> wavelength_nm{300.0, 337.1, 550.0, 694.3, 1060.0};
  std::vector<double> single_scattering_albedo{0.9379, 0.9521, 0.9462, 0.9378, 0.8714};
  std::vector<double> asymmetry{0.6928, 0.6865, 0.6630, 0.6498, 0.6314};

  /// Used unless the profile says where the aerosol is.
  AerosolShape shape;

  /// @throws InputError  naming the member that is out of range: exponent in [-1, 4], albedo in [0, 1],
  ///                     |asymmetry| < 1, wavelengths ascending, all lists of one length, heights > 0
  void validate() const;

  double single_scattering_albedo_at(double wavelength_nm) const;
  double asymmetry_at(double wavelength_nm) const;

  /// Phase function at one wavelength: Henyey-Greenstein of the asymmetry. (Whoever has a better one
  /// returns it here: transfer knows PhaseFunction alone.)
  std::shared_ptr<const PhaseFunction> phase_function(double wavelength_nm) const;

  /// τ(λ) / τ(500 nm).
  double relative_depth(double wavelength_nm) const;
};

}  // namespace skylut
