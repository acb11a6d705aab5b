#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/constituent.hpp"
#include "skylut/atmosphere/ground_albedo.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/scattering/aerosol_optics.hpp"
#include "skylut/scattering/optical_column.hpp"

namespace skylut {

struct Context;
class AerosolConstituent;
class RayleighConstituent;

/// One refractive index bends the light of all wavelengths, so that they share their geometry; that of others
/// differs by +1.7 % (400 nm) to -1.1 % (780 nm). [docs/refraction.md §6]
inline constexpr double kRefractionWavelength_nm = 550.0;

/// What a profile leaves open.
struct AtmosphereOptions {
  GroundAlbedo ground_albedo = 0.2;  ///< Lambertian, [0, 1]
  /// Column of ozone above the ground, Dobson units, [0, 1000]; default: the profile's.
  std::optional<double> ozone_du;
  std::optional<double> no2_du;    ///< nitrogen dioxide, [0, 100]; default: the profile's
  std::optional<double> water_cm;  ///< precipitable water, [0, 20]; default: the profile's
  /// At the ground, [300, 1100]; default: the profile's. Scales pressure, air, oxygen and carbon dioxide at
  /// all levels, hence the Rayleigh and oxygen depths; temperature and the other gases' columns stay.
  std::optional<double> surface_pressure_hPa;
  /// Gravity at the ground; profiles are in balance under standard gravity, see Atmosphere. [9.7, 9.9].
  double gravity_m_s2 = kStandardGravity_m_s2;
  double planet_radius_km = kMeanEarthRadius_km;  ///< of the ground, [1000, inf)
  AerosolOptics aerosol;
  bool refraction = false;  ///< the shells bend light, by the profile's own air
};

/// Vertical optical depth of one constituent.
struct ConstituentDepth {
  std::string name;  ///< of the constituent
  double depth = 0.0;
};

/// What one constituent does to a band.
struct ConstituentExtinction {
  std::string name;                   ///< of the constituent
  std::vector<ExtinctionTerm> terms;  ///< weights sum to 1; one term unless lines absorb
};

/// One monochromatic column; the radiance of a band is the weighted sum over its columns.
struct BandColumn {
  double weight = 1.0;  ///< [0, 1]; those of a band sum to 1
  OpticalColumn column;
};

/// The air above a place, as light sees it: levels, a list of constituents between them, and a ground. Built
/// once from a profile and what it leaves open; answers for any wavelength and aerosol load, and describes
/// itself into every file that is made with it.
///
/// Another gravity g than the standard's g0 leaves pressure and temperature at the ground as they are
/// and stretches the air by g0/g, so that its column is p/(m g). [docs/air.md §6]
///
/// Immutable once built; its functions may be called by several threads.
class Atmosphere {
 public:
  /// @param more  further constituents (a cloud, a plume of smoke), after the air's own
  /// @throws InputError  for options out of range (naming option and value), or two constituents of one name
  /// @throws WorkError   if a data table is missing
  Atmosphere(const Context& context, Profile profile, AtmosphereOptions options,
             std::vector<std::unique_ptr<Constituent>> more = {});
  ~Atmosphere();
  Atmosphere(Atmosphere&&) noexcept;
  Atmosphere& operator=(Atmosphere&&) noexcept;

  /// The profile as it is used: columns and pressure scaled as the options ask.
  const Profile& profile() const { return *profile_; }
  const AtmosphereOptions& options() const { return options_; }
  const AerosolOptics& aerosol() const { return options_.aerosol; }

  /// Levels from the ground to 100 km, 0.1 km apart at the ground, 20 km at the top, and the constituents'
  /// own boundaries.
  /// With the option, they have the air's refractivity at kRefractionWavelength_nm.
  const Shells& shells() const { return shells_; }
  /// The same with the refractivity at another wavelength, which is as dispersive as dry air.
  Shells shells_at(double wavelength_nm) const;

  /// Layers of one wavelength and load, without the lines of oxygen and water vapour, which only a band can
  /// tell (band_columns).
  /// @param wavelength_nm  [300, 1000]
  /// @param aod500         total vertical aerosol optical depth above the ground at 500 nm, >= 0
  /// @throws InputError  for values out of range
  OpticalColumn column(double wavelength_nm, double aod500) const;

  /// What each constituent does to a band, layer by layer, in the order of optical_depths, with all the terms
  /// there are.
  /// @throws InputError  for values out of range
  std::vector<ConstituentExtinction> extinctions(const Band& band, double aod500) const;

  /// The columns whose weighted radiances are the band's: every combination of the constituents' terms, of
  /// which lines have one to three (fit_exponentials). 81 bands of 5 nm over 380-780 nm: some 25 columns
  /// more than bands.
  /// @throws InputError  as extinctions
  std::vector<BandColumn> band_columns(const Band& band, double aod500) const;

  /// Optical depth of every constituent above an altitude of the shells, in the order Rayleigh, absorbing
  /// gases, lines, aerosol, others.
  /// @param altitude_km  [0, top]
  std::vector<ConstituentDepth> optical_depths(const Band& band, double aod500,
                                               double altitude_km = 0.0) const;

  /// Rayleigh optical depth of the whole column.
  double rayleigh_depth(double wavelength_nm) const;

  /// Extinction coefficients at the ground, 1/km.
  double rayleigh_extinction_at_ground_per_km(double wavelength_nm) const;
  double aerosol_extinction_at_ground_per_km(double wavelength_nm, double aod500) const;

  /// Aerosol optical depth of the whole column; and the load, at 500 nm, of which it is that.
  /// @param aod500, depth  finite, >= 0
  double aerosol_depth(double wavelength_nm, double aod500) const;
  double aod500_of_aerosol_depth(double wavelength_nm, double depth) const;

  /// Depolarisation ratio of the molecules' scattering.
  double depolarisation(double wavelength_nm) const;

  /// Every number beside the profile's: ground, pressure, columns, gravity, radius, levels, and each
  /// constituent under its name.
  nlohmann::ordered_json describe() const;

 private:
  void check(double wavelength_nm, double aod500) const;
  OpticalColumn scattering_column(double wavelength_nm, double aod500) const;

  std::shared_ptr<const Profile> profile_;
  AtmosphereOptions options_;
  Shells shells_;
  std::vector<std::unique_ptr<Constituent>> constituents_;
  // Two of them, for what only they can tell.
  const RayleighConstituent* rayleigh_ = nullptr;
  const AerosolConstituent* aerosol_ = nullptr;
};

}  // namespace skylut
