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
};

/// What aerosol does to light, per unit of optical depth. The default is rural aerosol.
struct AerosolOptics {
  /// τ(λ) = τ(500 nm) (λ / 500 nm)^-α. 1.3: Ångström's value for average haze.
  double angstrom_exponent = 1.3;

  /// Single-scattering albedo and asymmetry by wavelength, linear in between, held constant beyond the
  /// ends. Rural aerosol at 70 % relative humidity of Shettle and Fenn 1979 (AFGL-TR-79-0214).
  std::vector<double> wavelength_nm{300.0, 337.1, 550.0, 694.3, 1060.0};
  std::vector<double> single_scattering_albedo{0.938, 0.952, 0.946, 0.938, 0.873};
  std::vector<double> asymmetry{0.693, 0.687, 0.664, 0.650, 0.631};

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
