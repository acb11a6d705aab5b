#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "skylut/scattering/optical_column.hpp"

namespace skylut {

/// A band of wavelengths.
struct Band {
  double wavelength_nm = 550.0;  ///< its middle, [300, 1000]
  double width_nm = 5.0;         ///< (0, 100]
};

/// One way that a band's light is weakened: the part of the band that meets these depths.
struct ExtinctionTerm {
  double weight = 1.0;        ///< part of the band, [0, 1]
  std::vector<double> depth;  ///< vertical optical depth per layer, bottom to top, >= 0
};

/// Which terms of a band of lines: all there are (8 per nm), for transmittances without loss; or as few as
/// the transfer solver needs (fit_exponentials).
enum class BandTerms { all, few };

/// Something that the air is made of and that light meets: molecules, a gas, the lines of a gas, an aerosol,
/// a cloud. An atmosphere is a list of constituents; a new kind of matter is a new class. [docs/air.md]
///
/// Optical depths are vertical. `aod500` is the atmosphere's aerosol load (total vertical optical depth at
/// 500 nm, >= 0), which only constituents that scale with it heed.
class Constituent {
 public:
  virtual ~Constituent() = default;

  /// Short and unique within an atmosphere: "rayleigh", "ozone", "no2", "o2_o2", "oxygen", "water_vapour"
  /// (the lines of these two), "aerosol".
  virtual std::string name() const = 0;

  /// Whether its extinction at one wavelength has a meaning; that of lines has one only for a band.
  virtual bool is_smooth() const { return true; }

  /// Altitudes above the ground where its density has an edge; they become levels of the atmosphere.
  virtual std::vector<double> boundaries_km() const { return {}; }

  /// Told once, before anything else is asked: the levels of the atmosphere, ascending from 0. What follows
  /// is per layer between them.
  virtual void set_levels(const std::vector<double>& levels_km) = 0;

  /// Extinction by layer: a beam of air mass m keeps Σ weight exp(-m Σ depth) of the band, weights summing to
  /// 1. Layer depths are integrals of the continuous profile (relative accuracy 1e-8).
  virtual std::vector<ExtinctionTerm> extinction(const Band& band, double aod500, BandTerms terms) const = 0;

  /// Optical depth above an altitude; for lines -ln of the band's vertical transmittance, which does not grow
  /// with the air mass as other depths do.
  virtual double depth_above(const Band& band, double aod500, double altitude_km) const = 0;

  /// What scatters, with scattering depths per layer that do not exceed the extinction's.
  virtual std::vector<Scatterer> scatterers(double wavelength_nm, double aod500) const;

  /// Every number it is made of, for the provenance of files.
  virtual nlohmann::ordered_json describe() const = 0;
};

}  // namespace skylut
