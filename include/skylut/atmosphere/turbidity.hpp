#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skylut/atmosphere/atmosphere.hpp"

namespace skylut {

/// The ways to say how much aerosol there is. All mean the total column above the ground.
enum class TurbidityKind {
  aod500,         ///< aerosol optical depth at 500 nm, >= 0 (SMARTS2's, the report's)
  aod550,         ///< at 550 nm, >= 0
  angstrom_beta,  ///< Ångström's β: optical depth at 1000 nm, >= 0
  preetham_t,     ///< T = (τ_R + τ_A) / τ_R at 550 nm, >= 1 (UTM report 2005 eq. 2.8)
  visibility_km,  ///< Koschmieder: 3.912 / extinction at 550 nm and ground level, km
};

/// All kinds, in the order above.
std::vector<TurbidityKind> turbidity_kinds();

/// "aod500", "aod550", "angstrom-beta", "preetham-t", "visibility-km".
std::string_view turbidity_kind_name(TurbidityKind kind);

/// @throws InputError  naming the text and the five names
TurbidityKind parse_turbidity_kind(const std::string& text);

struct Turbidity {
  TurbidityKind kind = TurbidityKind::aod500;
  double value = 0.0;
};

/// Aerosol optical depth at 500 nm that a turbidity means in this air (its Rayleigh depth, Ångström
/// exponent and vertical shape). An infinite visibility means no aerosol.
/// @throws InputError  negative or not finite, T < 1, or a visibility beyond that of air without
///                     aerosol (about 340 km at sea level)
double to_aod500(const Turbidity& turbidity, const Atmosphere& air);

/// The inverse. @param aod500  >= 0
double from_aod500(double aod500, TurbidityKind kind, const Atmosphere& air);

/// Visibility from McClatchey and Selby 1972 (UTM report 2005, closing paper; Iqbal 1983 eq. 6.6.4):
/// β = 0.55^α (3.912/V - 0.01162) (0.02472 (V - 5) + 1.132), solved for V, km. 336.7 for β = 0.
double mcclatchey_selby_visibility_km(double angstrom_beta, double angstrom_exponent);

/// β of that relation. @param visibility_km  > 0, at most 336.7
double mcclatchey_selby_beta(double visibility_km, double angstrom_exponent);

}  // namespace skylut
