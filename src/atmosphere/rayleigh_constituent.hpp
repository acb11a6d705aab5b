#pragma once

#include <memory>

#include "skylut/atmosphere/constituent.hpp"
#include "skylut/profile/profile.hpp"

namespace skylut {

/// Molecules of dry air: they scatter after Bodhaine et al. 1999. [docs/air.md §4]
class RayleighConstituent final : public Constituent {
 public:
  RayleighConstituent(std::shared_ptr<const Profile> profile, double gravity_m_s2);

  std::string name() const override { return "rayleigh"; }
  void set_levels(const std::vector<double>& levels_km) override;
  std::vector<ExtinctionTerm> extinction(const Band& band, double aod500, BandTerms terms) const override;
  double depth_above(const Band& band, double aod500, double altitude_km) const override;
  std::vector<Scatterer> scatterers(double wavelength_nm, double aod500) const override;
  nlohmann::ordered_json describe() const override;

  /// Carbon dioxide's mole fraction at the ground, for the cross-section.
  double carbon_dioxide_fraction() const { return carbon_dioxide_fraction_; }
  double extinction_at_ground_per_km(double wavelength_nm) const;

  /// Refractive index minus 1 of the profile's air, water vapour included.
  double refractivity(double wavelength_nm, double altitude_km) const;
  static const char* refractivity_source();

 private:
  std::vector<double> depths(double wavelength_nm) const;

  std::shared_ptr<const Profile> profile_;
  double gravity_m_s2_;
  double carbon_dioxide_fraction_;
  std::vector<double> air_per_m2_;  // by layer
};

}  // namespace skylut
