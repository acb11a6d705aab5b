#include "skylut/scattering/aerosol_optics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optics_cache.hpp"
#include "particle_optics.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/interpolation.hpp"

namespace skylut {

namespace {

constexpr double kReferenceWavelength_nm = 500.0;

// Where Mie's theory is evaluated. 50 nm: phase functions halfway between are within 1 % of the mixture of
// their neighbours (tests/unit/scattering/aerosol_presets_test.cpp).
const std::vector<double> kWavelengths_nm{300.0, 350.0, 400.0, 450.0, 500.0, 550.0, 600.0,
                                          650.0, 700.0, 750.0, 800.0, 900.0, 1000.0};

// Value of a list at a place between two of its wavelengths.
double between(const std::vector<double>& y, const Bracket& at) {
  return linear(y[at.below], y[at.above], at.part);
}

// Share of the upper neighbour in the scattered light.
double share_of_upper(const AerosolOptics& aerosol, const Bracket& at) {
  if (aerosol.relative_extinction.empty()) return at.part;
  const auto scattering = [&](std::size_t i) {
    return aerosol.relative_extinction[i] * aerosol.single_scattering_albedo[i];
  };
  const double lower = (1.0 - at.part) * scattering(at.below);
  const double upper = at.part * scattering(at.above);
  return lower + upper > 0.0 ? upper / (lower + upper) : at.part;
}

void set_given(const GivenOptics& given, AerosolOptics& aerosol) {
  aerosol.angstrom_exponent = given.angstrom_exponent;
  aerosol.wavelength_nm = given.wavelength_nm;
  aerosol.single_scattering_albedo = given.single_scattering_albedo;
  aerosol.asymmetry = given.asymmetry;
}

void set_particles(const Context& context, const std::vector<AerosolComponent>& components,
                   AerosolOptics& aerosol) {
  const std::string key = optics_key(components, kWavelengths_nm);
  std::optional<std::vector<ParticleOptics>> results = find_in_cache(context, key);
  if (!results || results->size() != kWavelengths_nm.size()) {
    results = particle_optics(context, components, kWavelengths_nm);
    keep_in_cache(context, key, *results);
  }
  const auto reference = std::find(kWavelengths_nm.begin(), kWavelengths_nm.end(), kReferenceWavelength_nm);
  const double extinction =
      (*results)[static_cast<std::size_t>(reference - kWavelengths_nm.begin())].extinction_um2;
  if (!(extinction > 0.0))
    throw InputError("aerosol '{}': its particles do not meet any light", aerosol.name);
  aerosol.wavelength_nm = kWavelengths_nm;
  aerosol.single_scattering_albedo.clear();
  aerosol.asymmetry.clear();
  for (ParticleOptics& optics : *results) {
    aerosol.relative_extinction.push_back(optics.extinction_um2 / extinction);
    aerosol.single_scattering_albedo.push_back(std::min(1.0, optics.scattering_um2 / optics.extinction_um2));
    aerosol.asymmetry.push_back(optics.moments[1]);
    aerosol.phase.push_back(
        std::make_shared<TabulatedPhaseFunction>(std::move(optics.moments), std::move(optics.polarisation)));
  }
  aerosol.angstrom_exponent = aerosol.angstrom_exponent_between(500.0, 1000.0);
}

}  // namespace

void AerosolOptics::validate() const {
  // Of particles it follows from their extinction and rules nothing.
  if (relative_extinction.empty())
    require_within("Angstrom exponent", angstrom_exponent, domain::kAngstromExponent);
  if (wavelength_nm.empty() || single_scattering_albedo.size() != wavelength_nm.size() ||
      asymmetry.size() != wavelength_nm.size())
    throw InputError(
        "aerosol with {} wavelengths, {} albedos, {} asymmetries: must have as many of each, at least 1",
        wavelength_nm.size(), single_scattering_albedo.size(), asymmetry.size());
  if (!relative_extinction.empty() && relative_extinction.size() != wavelength_nm.size())
    throw InputError("aerosol with {} wavelengths, {} extinctions: must have as many of each",
                     wavelength_nm.size(), relative_extinction.size());
  if (!phase.empty() && phase.size() != wavelength_nm.size())
    throw InputError("aerosol with {} wavelengths, {} phase functions: must have as many of each",
                     wavelength_nm.size(), phase.size());
  for (std::size_t i = 0; i < wavelength_nm.size(); ++i) {
    if (!(wavelength_nm[i] > (i == 0 ? 0.0 : wavelength_nm[i - 1])))
      throw InputError("aerosol wavelength {} nm: must be greater than the one before", wavelength_nm[i]);
    if (!(single_scattering_albedo[i] >= 0.0 && single_scattering_albedo[i] <= 1.0))
      throw InputError("aerosol single-scattering albedo {} at {} nm: must lie within 0-1",
                       single_scattering_albedo[i], wavelength_nm[i]);
    if (!(std::abs(asymmetry[i]) < 1.0))
      throw InputError("aerosol asymmetry {} at {} nm: must lie between -1 and 1", asymmetry[i],
                       wavelength_nm[i]);
    if (!relative_extinction.empty() && !(relative_extinction[i] > 0.0))
      throw InputError("aerosol extinction {} at {} nm: must be greater than 0", relative_extinction[i],
                       wavelength_nm[i]);
  }
  shape.validate();
}

double AerosolOptics::single_scattering_albedo_at(double at_nm) const {
  return between(single_scattering_albedo, held_bracket(wavelength_nm, at_nm));
}

double AerosolOptics::asymmetry_at(double at_nm) const {
  Bracket at = held_bracket(wavelength_nm, at_nm);
  at.part = share_of_upper(*this, at);
  return between(asymmetry, at);
}

std::shared_ptr<const PhaseFunction> AerosolOptics::phase_function(double at_nm) const {
  if (phase.empty()) return std::make_shared<HenyeyGreensteinPhaseFunction>(asymmetry_at(at_nm));
  const Bracket at = held_bracket(wavelength_nm, at_nm);
  const double part = share_of_upper(*this, at);
  if (part == 0.0) return phase[at.below];
  return std::make_shared<TabulatedPhaseFunction>(*phase[at.below], *phase[at.above], part);
}

double AerosolOptics::relative_depth(double at_nm) const {
  if (relative_extinction.empty()) return std::pow(at_nm / kReferenceWavelength_nm, -angstrom_exponent);
  const Bracket at = held_bracket(wavelength_nm, at_nm);
  if (at.below == at.above) return relative_extinction[at.below];
  const double part =
      std::log(at_nm / wavelength_nm[at.below]) / std::log(wavelength_nm[at.above] / wavelength_nm[at.below]);
  return log_linear(relative_extinction[at.below], relative_extinction[at.above], part);
}

double AerosolOptics::angstrom_exponent_between(double first_nm, double second_nm) const {
  return -std::log(relative_depth(first_nm) / relative_depth(second_nm)) / std::log(first_nm / second_nm);
}

double AerosolOptics::depth(double at_nm, double aod500) const {
  const double stratospheric = aod500 * shape.stratospheric_share(aod500);
  return stratospheric * stratospheric_optics().relative_depth(at_nm) +
         (aod500 - stratospheric) * relative_depth(at_nm);
}

double AerosolOptics::aod500_of_depth(double at_nm, double depth_there) const {
  // Linear on either side of the load that is stratospheric altogether.
  const double stratospheric = stratospheric_optics().relative_depth(at_nm);
  const double knee = shape.stratospheric_aod500;
  if (depth_there <= knee * stratospheric) return depth_there / stratospheric;
  return knee + (depth_there - knee * stratospheric) / relative_depth(at_nm);
}

AerosolOptics aerosol_optics(const Context& context, const AerosolDescription& description) {
  AerosolOptics aerosol;
  aerosol.name = description.name;
  aerosol.shape = description.shape;
  aerosol.description = std::make_shared<const AerosolDescription>(description);
  if (description.optics)
    set_given(*description.optics, aerosol);
  else
    set_particles(context, description.components, aerosol);
  if (!description.stratosphere.empty())
    aerosol.stratosphere =
        std::make_shared<const AerosolOptics>(load_aerosol(context, description.stratosphere));
  aerosol.validate();
  return aerosol;
}

AerosolOptics load_aerosol(const Context& context, const std::string& name_or_path,
                           std::optional<double> humidity_percent) {
  return aerosol_optics(context, load_aerosol_description(context, name_or_path, humidity_percent));
}

}  // namespace skylut
