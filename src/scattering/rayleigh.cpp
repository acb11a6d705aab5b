#include "skylut/scattering/rayleigh.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// Molecules per m³ at 288.15 K and 1013.25 hPa (Bodhaine et al. 1999 §3); n below belongs to it.
constexpr double kStandardDensity_per_m3 = 2.546899e25;

// Composition of dry air by volume, percent (Bodhaine et al. 1999 eq. 23).
constexpr double kNitrogen_percent = 78.084;
constexpr double kOxygen_percent = 20.946;
constexpr double kArgon_percent = 0.934;

// 1/λ² in µm⁻².
double inverse_square_per_um2(double wavelength_nm) {
  if (!(wavelength_nm >= 230.0 && wavelength_nm <= 1690.0))
    throw InputError("wavelength {} nm: must lie within 230-1690 nm, the refractive index of air",
                     wavelength_nm);
  return 1e6 / (wavelength_nm * wavelength_nm);
}

}  // namespace

double refractivity_peck_reeder1972(double wavelength_nm, double carbon_dioxide_fraction) {
  const double s = inverse_square_per_um2(wavelength_nm);
  const double at_300_ppm = 1e-8 * (8060.51 + 2480990.0 / (132.274 - s) + 17455.7 / (39.32957 - s));
  return at_300_ppm * (1.0 + 0.54 * (carbon_dioxide_fraction - 0.0003));
}

double refractivity_of_air(double wavelength_nm, double carbon_dioxide_fraction, double air_per_m3,
                           double water_per_m3) {
  const double s = inverse_square_per_um2(wavelength_nm);
  // Ciddor's standard water vapour: 293.15 K, 1333 Pa.
  constexpr double kWaterDensity_per_m3 = 1333.0 / (1.380649e-23 * 293.15);
  const double water = 1.022e-8 * (295.235 + s * (2.6422 + s * (-0.032380 + s * 0.004028)));
  return refractivity_peck_reeder1972(wavelength_nm, carbon_dioxide_fraction) * (air_per_m3 - water_per_m3) /
             kStandardDensity_per_m3 +
         water * water_per_m3 / kWaterDensity_per_m3;
}

double king_factor_bates1984(double wavelength_nm, double carbon_dioxide_fraction) {
  const double s = inverse_square_per_um2(wavelength_nm);
  const double nitrogen = 1.034 + 3.17e-4 * s;
  const double oxygen = 1.096 + 1.385e-3 * s + 1.448e-4 * s * s;
  const double carbon_dioxide_percent = 100.0 * carbon_dioxide_fraction;
  return (kNitrogen_percent * nitrogen + kOxygen_percent * oxygen + kArgon_percent * 1.00 +
          carbon_dioxide_percent * 1.15) /
         (kNitrogen_percent + kOxygen_percent + kArgon_percent + carbon_dioxide_percent);
}

double depolarisation_of_air(double wavelength_nm, double carbon_dioxide_fraction) {
  const double king_factor = king_factor_bates1984(wavelength_nm, carbon_dioxide_fraction);
  return 6.0 * (king_factor - 1.0) / (3.0 + 7.0 * king_factor);
}

double rayleigh_cross_section_m2(double wavelength_nm, double carbon_dioxide_fraction) {
  const double n = 1.0 + refractivity_peck_reeder1972(wavelength_nm, carbon_dioxide_fraction);
  const double lorentz = (n * n - 1.0) / (n * n + 2.0);
  const double wavelength_m = 1e-9 * wavelength_nm;
  const double square = wavelength_m * wavelength_m * kStandardDensity_per_m3;
  return 24.0 * kPi * kPi * kPi * lorentz * lorentz / (square * square) *
         king_factor_bates1984(wavelength_nm, carbon_dioxide_fraction);
}

}  // namespace skylut
