#include "skylut/scattering/rayleigh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

constexpr double kCarbonDioxide = 360e-6;

// Bodhaine et al. 1999, eq. 29: their fit to the first-principles cross-section, 1e-28 cm².
double published_fit_m2(double wavelength_nm) {
  const double square = wavelength_nm * wavelength_nm * 1e-6;
  return 1e-32 * (1.0455996 - 341.29061 / square - 0.90230850 * square) /
         (1.0 + 0.0027059889 / square - 85.968563 * square);
}

// They state that the fit is good to 0.01 % over 250-850 nm.
TEST(Rayleigh, CrossSectionIsThePublishedOne) {
  for (double wavelength_nm = 300.0; wavelength_nm <= 850.0; wavelength_nm += 25.0)
    EXPECT_NEAR(rayleigh_cross_section_m2(wavelength_nm, kCarbonDioxide) / published_fit_m2(wavelength_nm),
                1.0, 1.2e-4)
        << wavelength_nm;
}

// Refractive index of standard air at 589.3 nm: n - 1 = 2.7716e-4 (Peck and Reeder 1972, 300 ppm).
TEST(Rayleigh, RefractiveIndexOfSodiumLight) {
  EXPECT_NEAR(refractivity_peck_reeder1972(589.3, 300e-6), 2.7716e-4, 3e-8);
  // Doubled CO2 adds 0.54 of its fraction.
  EXPECT_NEAR(refractivity_peck_reeder1972(500.0, 1300e-6) / refractivity_peck_reeder1972(500.0, 300e-6),
              1.00054, 1e-9);
}

// By hand at 300 nm (Bates 1984: N2 1.034 + 3.17e-4/λ², O2 1.096 + 1.385e-3/λ² + 1.448e-4/λ⁴, λ in µm):
// 0.78084 · 1.03752 + 0.20946 · 1.12926 + 0.00934 + 0.00036 · 1.15 = 1.05643; at
// 589.3 nm likewise 1.04851. (Young 1980 recommends one value for all visible light, 1.048.)
TEST(Rayleigh, KingFactorOfBates) {
  EXPECT_NEAR(king_factor_bates1984(300.0, kCarbonDioxide), 1.05643, 2e-5);
  EXPECT_NEAR(king_factor_bates1984(589.3, kCarbonDioxide), 1.04851, 1e-5);
  const double rho = depolarisation_of_air(550.0, kCarbonDioxide);
  EXPECT_NEAR((6.0 + 3.0 * rho) / (6.0 - 7.0 * rho), king_factor_bates1984(550.0, kCarbonDioxide), 1e-14);
  EXPECT_NEAR(rho, 0.0280, 5e-4);  // Young 1980: 0.0279 for visible light
}

// τ = σ p/(m g) (their eq. 24), m that of dry air (eq. 17).
double optical_depth(double wavelength_nm, double pressure_hPa, double gravity_m_s2) {
  const double molecule_kg = 1e-3 * (15.0556 * kCarbonDioxide + 28.9595) / kAvogadro_per_mol;
  return rayleigh_cross_section_m2(wavelength_nm, kCarbonDioxide) * 100.0 * pressure_hPa /
         (molecule_kg * gravity_m_s2);
}

// Bodhaine et al. 1999, eq. 30: 0.0021520 times the cross-section's fit is the optical depth at 1013.25
// hPa, 45°, sea level; their effective gravity there is 9.78916 m/s² (eq. 25-26, z_c = 5517.56 m).
TEST(Rayleigh, OpticalDepthIsThePublishedOne) {
  for (double wavelength_nm : {400.0, 500.0, 550.0, 600.0, 700.0}) {
    const double published = 0.0021520e32 * published_fit_m2(wavelength_nm);
    EXPECT_NEAR(optical_depth(wavelength_nm, 1013.25, 9.78916) / published, 1.0, 2e-4) << wavelength_nm;
  }
  EXPECT_NEAR(optical_depth(550.0, 1013.25, 9.78916), 0.0970, 1e-4);
}

TEST(Rayleigh, OutsideTheMeasuredWavelengths) {
  EXPECT_THROW(rayleigh_cross_section_m2(229.0, kCarbonDioxide), InputError);
  EXPECT_THROW(rayleigh_cross_section_m2(NAN, kCarbonDioxide), InputError);
}

}  // namespace
}  // namespace skylut
