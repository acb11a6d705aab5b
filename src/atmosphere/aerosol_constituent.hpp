#pragma once

#include <memory>

#include "skylut/atmosphere/constituent.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/scattering/aerosol_optics.hpp"

namespace skylut {

/// An aerosol: haze near the ground and a thin stratospheric part whose optical depth does not follow the
/// load; or, where the profile says where the aerosol is, haze alone. [docs/air.md §7, docs/aerosols.md]
class AerosolConstituent final : public Constituent {
 public:
  AerosolConstituent(std::shared_ptr<const Profile> profile, std::shared_ptr<const AerosolOptics> optics);

  std::string name() const override { return "aerosol"; }
  void set_levels(const std::vector<double>& levels_km) override { levels_km_ = levels_km; }
  std::vector<ExtinctionTerm> extinction(const Band& band, double aod500, BandTerms terms) const override;
  double depth_above(const Band& band, double aod500, double altitude_km) const override;
  std::vector<Scatterer> scatterers(double wavelength_nm, double aod500) const override;
  nlohmann::ordered_json describe() const override;

  /// Optical depth of the whole column; and the load, at 500 nm, of which it is that.
  double depth(double wavelength_nm, double aod500) const;
  double aod500_of_depth(double wavelength_nm, double depth) const;
  double extinction_at_ground_per_km(double wavelength_nm, double aod500) const;

 private:
  struct Depth {
    double haze;
    double stratospheric;
  };
  Depth between(double lower_km, double upper_km, double wavelength_nm, double aod500) const;
  // A profile that says where the aerosol is knows no stratospheric part.
  bool has_stratospheric_part() const { return profile_->relative_aerosol_extinction.empty(); }

  std::shared_ptr<const Profile> profile_;
  std::shared_ptr<const AerosolOptics> optics_;
  std::vector<double> levels_km_;
};

}  // namespace skylut
