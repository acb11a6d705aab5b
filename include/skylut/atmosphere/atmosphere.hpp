#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skylut/atmosphere/absorbing_gas.hpp"
#include "skylut/atmosphere/ground_albedo.hpp"
#include "skylut/atmosphere/line_absorption.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/scattering/aerosol_optics.hpp"
#include "skylut/scattering/optical_column.hpp"

namespace skylut {

struct Context;

/// What a profile leaves open.
struct AtmosphereOptions {
  GroundAlbedo ground_albedo = 0.2;  ///< Lambertian, [0, 1]
  std::optional<double>
      ozone_du;                  ///< column above the ground, Dobson units, [0, 1000]; default: the profile's
  std::optional<double> no2_du;  ///< nitrogen dioxide, [0, 100]; default: the profile's
  std::optional<double> water_cm;  ///< precipitable water, [0, 20]; default: the profile's
  /// At the ground, [300, 1100]; default: the profile's. Scales pressure, air, oxygen and carbon dioxide at
  /// all levels, hence the Rayleigh and oxygen depths; temperature and the other gases' columns stay.
  std::optional<double> surface_pressure_hPa;
  /// Gravity at the ground; profiles are in balance under standard gravity, see Atmosphere. [9.7, 9.9].
  double gravity_m_s2 = kStandardGravity_m_s2;
  double planet_radius_km = kMeanEarthRadius_km;  ///< of the ground, [1000, inf]
  AerosolOptics aerosol;
};

/// Vertical optical depth of one constituent between two altitudes.
struct ConstituentDepth {
  /// "rayleigh", "ozone", "no2", "o2_o2", "oxygen", "water_vapour" (the lines of these), "aerosol"
  std::string name;
  double depth = 0.0;
};

/// One way that a band's light is absorbed: the part of the band that meets these depths.
struct AbsorptionTerm {
  double weight = 1.0;        ///< part of the band, [0, 1]
  std::vector<double> depth;  ///< vertical optical depth per layer, bottom to top, >= 0
};

/// What one constituent does to a band of wavelengths: T(m) = Σ weight exp(-m Σ depth) for air mass m. A
/// smooth constituent has one term of weight 1; a band of lines has several, whose weights sum to 1.
struct Constituent {
  std::string name;  ///< as in ConstituentDepth
  std::vector<AbsorptionTerm> terms;
};

/// One lane of the solver; the radiance of a band is the weighted sum over its lanes.
struct ColumnTerm {
  double weight = 1.0;  ///< [0, 1]; those of a band sum to 1
  OpticalColumn column;
};

/// A profile as light sees it: layers for the transfer equation, filled for any wavelength and load.
///
/// Another gravity g than the standard's g0 leaves pressure and temperature at the ground as they are
/// and stretches the air by g0/g, so that its column is p/(m g). [docs/air.md §6]
class Atmosphere {
 public:
  /// @throws InputError  for options out of range (naming option and value)
  Atmosphere(const Context& context, Profile profile, AtmosphereOptions options);

  const Profile& profile() const { return profile_; }
  const AtmosphereOptions& options() const { return options_; }

  /// Levels from the ground to 100 km, 0.1 km apart at the ground, 20 km at the top.
  const Shells& shells() const { return shells_; }

  /// Layers of one wavelength and load, without the lines of oxygen and water vapour, which only a band
  /// can tell (band_columns). Layer depths are integrals of
  /// the continuous profile (relative accuracy 1e-8), not level values times thickness.
  /// @param wavelength_nm  [300, 1000]
  /// @param aod500         total vertical aerosol optical depth above the ground at 500 nm, >= 0
  /// @throws InputError  for values out of range
  OpticalColumn column(double wavelength_nm, double aod500) const;

  /// What each constituent does to a band, layer by layer, in the order of optical_depths. Extinction
  /// for scatterers. Lines have all the terms there are (8 per nm of the band), for transmittances without
  /// loss; different gases' lines are independent: transmittances multiply.
  /// @param wavelength_nm  middle of the band, [300, 1000]
  /// @param band_nm        its width, > 0
  /// @throws InputError  for values out of range
  std::vector<Constituent> constituents(double wavelength_nm, double band_nm, double aod500) const;

  /// The columns whose weighted radiances are the band's: every combination of the constituents' terms, of
  /// which lines have one to three (fit_exponentials). 81 bands of 5 nm over 380-780 nm: some 25 columns
  /// more than bands.
  /// @throws InputError  as constituents
  std::vector<ColumnTerm> band_columns(double wavelength_nm, double band_nm, double aod500) const;

  /// Optical depth of every constituent above an altitude of the shells, in the order Rayleigh,
  /// absorbing gases, lines, aerosol. For lines: -ln of the band's vertical transmittance, which does not
  /// grow with the air mass as other depths do.
  /// @param altitude_km  [0, top]
  /// @param band_nm      of the lines, > 0
  std::vector<ConstituentDepth> optical_depths(double wavelength_nm, double aod500, double altitude_km = 0.0,
                                               double band_nm = 5.0) const;

  /// Rayleigh optical depth of the whole column.
  double rayleigh_depth(double wavelength_nm) const;

  /// Extinction coefficients at the ground, 1/km.
  double rayleigh_extinction_at_ground_per_km(double wavelength_nm) const;
  double aerosol_extinction_at_ground_per_km(double wavelength_nm, double aod500) const;

  /// Aerosol optical depth of the whole column; and the load, at 500 nm, of which it is that.
  /// @param aod500, depth  finite, >= 0
  double aerosol_depth(double wavelength_nm, double aod500) const;
  double aod500_of_aerosol_depth(double wavelength_nm, double depth) const;

  /// Carbon dioxide's mole fraction at the ground, for the Rayleigh cross-section.
  double carbon_dioxide_fraction() const { return carbon_dioxide_fraction_; }

 private:
  // Molecules of a gas in one state of the air: a node of the integral over a layer.
  struct ColumnNode {
    double temperature_K;
    double column_per_m2;            // per m⁵ for pairs
    double log_pressure;             // ln(p / 1013.25 hPa)
    double log_inverse_temperature;  // ln(273.15 K / T)
  };
  struct GasLayers {
    AbsorbingGas gas;
    std::vector<std::vector<ColumnNode>> nodes;  // by layer
  };
  struct LineLayers {
    std::string name;
    std::string gas_name;
    LineAbsorption lines;
    std::vector<std::vector<ColumnNode>> nodes;
  };

  static void check(double wavelength_nm, double aod500);
  std::vector<Constituent> smooth_constituents(double wavelength_nm, double aod500) const;
  // Scatterers and extinction 0.
  OpticalColumn scattering_column(double wavelength_nm, const std::vector<Constituent>& constituents,
                                  double aod500) const;
  static double absorption_depth(const CrossSection& cross_section, const std::vector<ColumnNode>& nodes,
                                 double wavelength_nm);
  static double scaled_amount_per_m2(const LineBand& band, const std::vector<ColumnNode>& nodes);
  std::vector<ColumnNode> gas_nodes(const std::string& gas_name, bool pairs, double lower_km,
                                    double upper_km) const;
  void scale_columns();
  // few_terms: as few as the solver's lanes need; otherwise all there are.
  Constituent line_constituent(const LineLayers& absorber, double wavelength_nm, double band_nm,
                               bool few_terms) const;
  std::vector<Constituent> all_constituents(double wavelength_nm, double band_nm, double aod500,
                                            bool few_terms) const;
  double air_between_per_m2(double lower_km, double upper_km) const;
  // Aerosol's optical depth between two altitudes.
  struct AerosolDepth {
    double haze;
    double layer;  // in the stratosphere
  };
  void add_aerosol(double wavelength_nm, double aod500, OpticalColumn& column) const;
  AerosolDepth aerosol_between(double lower_km, double upper_km, double wavelength_nm, double aod500) const;
  // A profile that says where the aerosol is knows no stratospheric layer.
  bool has_stratospheric_layer() const { return profile_.relative_aerosol_extinction.empty(); }

  Profile profile_;
  AtmosphereOptions options_;
  Shells shells_;
  double carbon_dioxide_fraction_ = 0.0;
  std::vector<double> air_per_m2_;  // by layer
  std::vector<GasLayers> absorbers_;
  std::vector<LineLayers> line_absorbers_;
};

}  // namespace skylut
