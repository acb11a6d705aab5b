#include "skylut/atmosphere/turbidity.hpp"

#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

// Koschmieder 1924: a black object vanishes where its contrast has fallen to 2 %, ln 50 = 3.912.
constexpr double kKoschmieder = 3.912;
constexpr double kVisibilityWavelength_nm = 550.0;
constexpr double kPreethamWavelength_nm = 550.0;
constexpr double kBetaWavelength_nm = 1000.0;

// McClatchey and Selby's relation, in the form of Iqbal 1983 eq. 6.6.4.
constexpr double kMolecules_per_km = 0.01162;
constexpr double kDepthSlope = 0.02472;
constexpr double kDepthOffset_km = 1.132 - 5.0 * kDepthSlope;

constexpr std::array<std::pair<TurbidityKind, std::string_view>, 5> kNames{{
    {TurbidityKind::aod500, "aod500"},
    {TurbidityKind::aod550, "aod550"},
    {TurbidityKind::angstrom_beta, "angstrom-beta"},
    {TurbidityKind::preetham_t, "preetham-t"},
    {TurbidityKind::visibility_km, "visibility-km"},
}};

// Aerosol extinction at the ground is linear in the load on either side of the stratospheric load.
double aod500_of_ground_extinction(double extinction_per_km, const Atmosphere& air) {
  const auto extinction = [&](double aod500) {
    return air.aerosol_extinction_at_ground_per_km(kVisibilityWavelength_nm, aod500);
  };
  const double knee = air.options().aerosol.shape.stratospheric_aod500;
  const double at_knee = extinction(knee);
  if (extinction_per_km < at_knee) return knee * extinction_per_km / at_knee;
  return knee + (extinction_per_km - at_knee) / (extinction(knee + 1.0) - at_knee);
}

double aod500_of_visibility(double visibility_km, const Atmosphere& air) {
  if (visibility_km == std::numeric_limits<double>::infinity()) return 0.0;
  if (!(visibility_km > 0.0)) throw InputError("visibility {} km: must be greater than 0", visibility_km);
  const double molecules_per_km = air.rayleigh_extinction_at_ground_per_km(kVisibilityWavelength_nm);
  const double clear_km = kKoschmieder / molecules_per_km;
  // A visibility that was computed from no aerosol at all may come back a rounding error longer.
  if (visibility_km > clear_km * (1.0 + 1e-12))
    throw InputError("visibility {} km: must not exceed {:.1f} km, that of air without aerosol (or be inf)",
                     visibility_km, clear_km);
  return aod500_of_ground_extinction(std::max(0.0, kKoschmieder / visibility_km - molecules_per_km), air);
}

}  // namespace

std::vector<TurbidityKind> turbidity_kinds() {
  std::vector<TurbidityKind> kinds;
  for (const auto& [kind, name] : kNames) kinds.push_back(kind);
  return kinds;
}

std::string_view turbidity_kind_name(TurbidityKind kind) {
  return kNames[static_cast<std::size_t>(kind)].second;
}

TurbidityKind parse_turbidity_kind(const std::string& text) {
  std::vector<std::string_view> names;
  for (const auto& [kind, name] : kNames) {
    if (text == name) return kind;
    names.push_back(name);
  }
  throw InputError("turbidity kind '{}': unknown; expected one of {}", text, fmt::join(names, ", "));
}

double to_aod500(const Turbidity& turbidity, const Atmosphere& air) {
  const double value = turbidity.value;
  if (turbidity.kind == TurbidityKind::visibility_km) return aod500_of_visibility(value, air);
  const double least = turbidity.kind == TurbidityKind::preetham_t ? 1.0 : 0.0;
  if (!(value >= least) || !std::isfinite(value))
    throw InputError("turbidity {} ({}): must be finite and at least {}", value,
                     turbidity_kind_name(turbidity.kind), least);
  switch (turbidity.kind) {
    case TurbidityKind::aod550:
      return air.aod500_of_aerosol_depth(550.0, value);
    case TurbidityKind::angstrom_beta:
      return air.aod500_of_aerosol_depth(kBetaWavelength_nm, value);
    case TurbidityKind::preetham_t:
      return air.aod500_of_aerosol_depth(kPreethamWavelength_nm,
                                         (value - 1.0) * air.rayleigh_depth(kPreethamWavelength_nm));
    default:
      return value;
  }
}

double from_aod500(double aod500, TurbidityKind kind, const Atmosphere& air) {
  if (!(aod500 >= 0.0) || !std::isfinite(aod500))
    throw InputError("aerosol optical depth {}: must be finite and not negative", aod500);
  switch (kind) {
    case TurbidityKind::aod550:
      return air.aerosol_depth(550.0, aod500);
    case TurbidityKind::angstrom_beta:
      return air.aerosol_depth(kBetaWavelength_nm, aod500);
    case TurbidityKind::preetham_t:
      return 1.0 +
             air.aerosol_depth(kPreethamWavelength_nm, aod500) / air.rayleigh_depth(kPreethamWavelength_nm);
    case TurbidityKind::visibility_km:
      return kKoschmieder / (air.rayleigh_extinction_at_ground_per_km(kVisibilityWavelength_nm) +
                             air.aerosol_extinction_at_ground_per_km(kVisibilityWavelength_nm, aod500));
    default:
      return aod500;
  }
}

double mcclatchey_selby_visibility_km(double angstrom_beta, double angstrom_exponent) {
  if (!(angstrom_beta >= 0.0) || !std::isfinite(angstrom_beta))
    throw InputError("Angstrom beta {}: must be finite and not negative", angstrom_beta);
  // (k/V - r)(s V + o) = b with b = β / 0.55^α: r s V² + (b + r o - k s) V - k o = 0, one positive root,
  // written without cancellation.
  const double b = angstrom_beta / std::pow(0.55, angstrom_exponent);
  const double linear = b + kMolecules_per_km * kDepthOffset_km - kKoschmieder * kDepthSlope;
  const double quadratic = kMolecules_per_km * kDepthSlope;
  const double constant = kKoschmieder * kDepthOffset_km;
  const double root = std::sqrt(linear * linear + 4.0 * quadratic * constant);
  return linear > 0.0 ? 2.0 * constant / (linear + root) : (root - linear) / (2.0 * quadratic);
}

double mcclatchey_selby_beta(double visibility_km, double angstrom_exponent) {
  const double clear_km = kKoschmieder / kMolecules_per_km;
  if (!(visibility_km > 0.0 && visibility_km <= clear_km))
    throw InputError("visibility {} km: must be greater than 0 and at most {:.1f} km", visibility_km,
                     clear_km);
  return std::pow(0.55, angstrom_exponent) * (kKoschmieder / visibility_km - kMolecules_per_km) *
         (kDepthSlope * visibility_km + kDepthOffset_km);
}

}  // namespace skylut
