#pragma once

#include <string>
#include <vector>

#include "skylut/atmosphere/spectral_curve.hpp"
#include "skylut/sky/sun_irradiance.hpp"

/// The sun's direct beam by formulas of one line each, for comparison with ours. [docs/air.md, "Closed
/// forms"]
namespace skylut {

struct Context;

enum class ClosedFormModel {
  iqbal,       ///< Iqbal 1983 (Preetham et al. 1999 A.1): one optical mass, that of Kasten 1966
  smarts_like  ///< the UTM report's closing paper: each constituent has its own optical mass (Gueymard 1994)
};

/// "iqbal", "smarts-like". @throws InputError  naming the text and the two names
ClosedFormModel parse_closed_form_model(const std::string& text);

/// Optical masses relative to the vertical; pressure over 1013.25 hPa is in those of well-mixed air.
struct OpticalMasses {
  double rayleigh = 1.0;
  double aerosol = 1.0;
  double ozone = 1.0;
  double mixed_gases = 1.0;
  double water_vapour = 1.0;
};

/// iqbal: m = 1/(cos z + 0.15 (93.885 - z)^-1.253) (Kasten 1966), z in degrees, times p/1013.25 hPa except
/// for ozone and water vapour. smarts-like: Gueymard's 1/(cos z + a z (b - z)^-c) with a, b, c of each
/// constituent.
/// @param zenith_deg    [0, 90]
/// @param pressure_hPa  at the observer, [0, 1100]
/// @throws InputError  for values out of range
OpticalMasses optical_masses(ClosedFormModel model, double zenith_deg, double pressure_hPa);

/// What the formulas know of the air above an observer.
struct ClosedFormAir {
  double angstrom_beta = 0.0;  ///< aerosol optical depth at 1000 nm, >= 0
  double angstrom_exponent = 1.3;
  double ozone_atm_cm = 0.0;  ///< >= 0
  double water_cm = 0.0;      ///< precipitable, >= 0
};

/// Absorption coefficients of the closed forms by wavelength.
struct ClosedFormAbsorption {
  SpectralCurve ozone_per_atm_cm;
  SpectralCurve mixed_gases;
  SpectralCurve water_vapour_per_cm;

  /// Reads profiles/spectra/closed_form_absorption.csv. @throws WorkError, InputError if it is missing or
  /// broken
  static ClosedFormAbsorption load(const Context& context);
};

/// Transmittances at one wavelength, in the order rayleigh, ozone, mixed_gases, water_vapour, aerosol:
///   exp(-0.008735 λ^-4.08 m), exp(-k l m), exp(-1.41 k m / (1 + 118.3 k m)^0.45),
///   exp(-0.2385 k w m / (1 + 20.07 k w m)^0.45), exp(-β λ^-α m), λ in µm (Leckner 1978, Ångström 1929)
/// with the coefficients k given.
std::vector<double> closed_form_transmittances(const ClosedFormAbsorption& absorption,
                                               const ClosedFormAir& air, const OpticalMasses& masses,
                                               double wavelength_nm);

/// The direct beam of simulate_sun by such a model; the same scene, without diffuse light. The air's columns
/// and pressure are those above the observer.
/// @throws InputError  as simulate_sun, and for a sun below the horizon
SunIrradiance simulate_sun_closed_form(const Context& context, const SkyScene& scene, ClosedFormModel model);

}  // namespace skylut
