#pragma once

/// Molecular scattering after Bodhaine, Wood, Dutton and Slusser 1999, J. Atmos. Oceanic Technol. 16,
/// 1854-1861, doi:10.1175/1520-0426(1999)016<1854:ORODC>2.0.CO;2, from first principles. Within 0.012 % of
/// their fit over 300-850 nm. [docs/air.md §4]
namespace skylut {

/// Refractive index of dry air minus 1 at 288.15 K and 1013.25 hPa, wavelength 230-1690 nm: Peck and
/// Reeder 1972, doi:10.1364/JOSA.62.000958 (300 ppm CO2), scaled to another CO2 content (Bodhaine eqs.
/// 18-19).
/// @param carbon_dioxide_fraction  mole fraction, e.g. 360e-6
double refractivity_peck_reeder1972(double wavelength_nm, double carbon_dioxide_fraction);

/// Refractive index minus 1 of moist air by its molecules: dry air as above, water vapour after Ciddor 1996,
/// doi:10.1364/AO.35.001566, each in proportion to its density. (The squares that the Lorentz-Lorenz rule
/// adds are 1e-4 of it.) A molecule of water counts for 0.87 of one of air: 0.2 % less in the moistest air.
/// @param air_per_m3, water_per_m3  molecules, water's among the air's; >= 0
double refractivity_of_air(double wavelength_nm, double carbon_dioxide_fraction, double air_per_m3,
                           double water_per_m3);

/// King factor F of dry air, the constituents' (Bates 1984, doi:10.1016/0032-0633(84)90102-8) weighted by
/// volume (Bodhaine eqs. 5-6, 23).
double king_factor_bates1984(double wavelength_nm, double carbon_dioxide_fraction);

/// Depolarisation ratio ρ of natural light, from F = (6 + 3ρ) / (6 - 7ρ).
double depolarisation_of_air(double wavelength_nm, double carbon_dioxide_fraction);

/// Scattering cross-section of a molecule of dry air, m²:
/// σ = 24 π³ (n² - 1)² F / (λ⁴ N_s² (n² + 2)²) (Bodhaine eq. 2), N_s = 2.546899e25 m⁻³.
/// @throws InputError  for a wavelength outside 230-1690 nm
double rayleigh_cross_section_m2(double wavelength_nm, double carbon_dioxide_fraction);

}  // namespace skylut
