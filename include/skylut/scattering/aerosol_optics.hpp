#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skylut/scattering/aerosol_description.hpp"
#include "skylut/scattering/aerosol_shape.hpp"
#include "skylut/scattering/phase_function.hpp"
#include "skylut/scattering/tabulated_phase_function.hpp"

namespace skylut {

struct Context;

/// What aerosol does to light, per unit of optical depth, and where it is. The default is rural aerosol with
/// a Henyey-Greenstein phase function; load_aerosol() gives better ones. [docs/aerosols.md]
struct AerosolOptics {
  std::string name = "henyey-greenstein";

  /// τ(λ) = τ(500 nm) (λ / 500 nm)^-α where relative_extinction is empty. 1.3: Ångström's value for average
  /// haze.
  double angstrom_exponent = 1.3;

  /// Single-scattering albedo and asymmetry by wavelength, held constant beyond the ends. Rural aerosol at
  /// 70 % relative humidity of Shettle and Fenn 1979 (AFGL-TR-79-0214).
  std::vector<double> wavelength_nm{300.0, 337.1, 550.0, 694.3, 1060.0};
  std::vector<double> single_scattering_albedo{0.9379, 0.9521, 0.9462, 0.9378, 0.8714};
  std::vector<double> asymmetry{0.6928, 0.6865, 0.6630, 0.6498, 0.6314};

  /// Extinction relative to that at 500 nm, and phase functions, at the same wavelengths; or both empty.
  std::vector<double> relative_extinction;
  std::vector<std::shared_ptr<const TabulatedPhaseFunction>> phase;

  /// What the particles are; none where the optics were given by hand.
  std::shared_ptr<const AerosolDescription> description;

  /// Used unless the profile says where the aerosol is.
  AerosolShape shape;
  /// Optics of the shape's stratospheric layer; none: the same as these.
  std::shared_ptr<const AerosolOptics> stratosphere;

  /// @throws InputError  naming the member that is out of range: exponent (where there is no
  ///                     relative_extinction) in domain::kAngstromExponent, albedo in [0, 1],
  ///                     |asymmetry| < 1, wavelengths ascending, all lists of one length, heights > 0
  void validate() const;

  /// Between the wavelengths: linear without relative_extinction, otherwise that of the mixture.
  double single_scattering_albedo_at(double wavelength_nm) const;
  double asymmetry_at(double wavelength_nm) const;

  /// Phase function at one wavelength: the mixture of the two neighbours' weighted by scattering, or
  /// Henyey-Greenstein of the asymmetry where there are none.
  std::shared_ptr<const PhaseFunction> phase_function(double wavelength_nm) const;

  /// τ(λ) / τ(500 nm) of the haze. Between the wavelengths, logarithm linear in that of λ.
  double relative_depth(double wavelength_nm) const;

  /// Ångström exponent of the haze between two wavelengths: -ln(τ1/τ2) / ln(λ1/λ2).
  double angstrom_exponent_between(double first_nm, double second_nm) const;

  /// Optics of the stratospheric layer: stratosphere, or these.
  const AerosolOptics& stratospheric_optics() const { return stratosphere ? *stratosphere : *this; }

  /// Total optical depth, haze and stratospheric layer, at a wavelength; and the load that has it.
  /// @param aod500  total optical depth at 500 nm, >= 0
  double depth(double wavelength_nm, double aod500) const;
  double aod500_of_depth(double wavelength_nm, double depth) const;
};

/// Optics of a description: Mie's theory for its particles, at 13 wavelengths from 300 to 1000 nm. Takes
/// 0.2-2.5 s of one core the first time, some 0.1 s later (kept in the context's cache folder).
AerosolOptics aerosol_optics(const Context& context, const AerosolDescription& description);

/// Reads and computes an aerosol. @throws InputError as load_aerosol_description()
AerosolOptics load_aerosol(const Context& context, const std::string& name_or_path,
                           std::optional<double> humidity_percent = std::nullopt);

}  // namespace skylut
