#pragma once

#include <vector>

namespace skylut {

/// Where an aerosol is: haze near the ground under a thin stratospheric layer whose optical depth does
/// not follow the haze. The haze is constant up to the top of its mixed layer and thins exponentially
/// above, or follows a table of relative extinction. [docs/air.md §7 A15, docs/aerosols.md]
struct AerosolShape {
  double mixed_layer_km = 0.0;  ///< extinction is constant up to here
  /// Scale height above that, km. Rural haze of Shettle and Fenn 1979 thins by e in 2.1 km.
  double haze_scale_height_km = 2.0;
  /// Instead of the two, if not empty: altitudes from 0 upwards and extinction in any unit; logarithm
  /// linear in between, nothing above the last.
  std::vector<double> altitude_km;
  std::vector<double> relative_extinction;

  /// Optical depth of the stratospheric layer at 500 nm: quiet years without large eruptions hold
  /// 0.004-0.006. A smaller load than this is stratospheric altogether.
  double stratospheric_aod500 = 0.005;
  double stratospheric_centre_km = 19.0;  ///< altitude of its maximum; Gaussian
  double stratospheric_width_km = 4.0;    ///< its standard deviation

  /// Share of the stratospheric layer in a total optical depth at 500 nm, [0, 1].
  double stratospheric_share(double aod500) const;

  /// Part of the haze, and of the layer, between two altitudes of an atmosphere that ends at top_km; 1
  /// over all.
  double haze_between(double lower_km, double upper_km, double top_km) const;
  double stratospheric_between(double lower_km, double upper_km, double top_km) const;

  /// Their derivatives: extinction at one altitude per unit of optical depth, 1/km.
  double haze_density_per_km(double altitude_km, double top_km) const;
  double stratospheric_density_per_km(double altitude_km, double top_km) const;

  /// Haze and layer together at 500 nm: shares of a total optical depth.
  double part_between(double lower_km, double upper_km, double top_km, double aod500) const;
  double density_per_km(double altitude_km, double top_km, double aod500) const;

  /// @throws InputError  naming the member that is out of range: mixed layer 0-10 km, scale height 0.1-20
  ///                     km, altitudes ascending from 0 with as many values >= 0, not all 0; layer's optical
  ///                     depth 0-100, altitude 5-40 km, width 0.5-10 km
  void validate() const;
};

}  // namespace skylut
