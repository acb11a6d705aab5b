#include "aerosol_constituent.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/scattering/aerosol_json.hpp"

namespace skylut {

AerosolConstituent::AerosolConstituent(std::shared_ptr<const Profile> profile,
                                       std::shared_ptr<const AerosolOptics> optics)
    : profile_(std::move(profile)), optics_(std::move(optics)) {}

AerosolConstituent::Depth AerosolConstituent::between(double lower_km, double upper_km, double wavelength_nm,
                                                      double aod500) const {
  if (aod500 <= 0.0) return {0.0, 0.0};
  const double top_km = profile_->altitude_km.back();
  if (!has_stratospheric_part()) {
    const GasProfile extinction{"aerosol", profile_->relative_aerosol_extinction};
    return {aod500 * optics_->relative_depth(wavelength_nm) *
                gas_column_per_m2(*profile_, extinction, lower_km, upper_km) /
                gas_column_per_m2(*profile_, extinction, 0.0, top_km),
            0.0};
  }
  const double stratospheric500 = aod500 * optics_->shape.stratospheric_share(aod500);
  return {(aod500 - stratospheric500) * optics_->relative_depth(wavelength_nm) *
              optics_->shape.haze_between(lower_km, upper_km, top_km),
          stratospheric500 * optics_->stratospheric_optics().relative_depth(wavelength_nm) *
              optics_->shape.stratospheric_between(lower_km, upper_km, top_km)};
}

std::vector<ExtinctionTerm> AerosolConstituent::extinction(const Band& band, double aod500, BandTerms) const {
  ExtinctionTerm term;
  for (std::size_t layer = 0; layer + 1 < levels_km_.size(); ++layer) {
    const Depth depth = between(levels_km_[layer], levels_km_[layer + 1], band.wavelength_nm, aod500);
    term.depth.push_back(depth.haze + depth.stratospheric);
  }
  return {std::move(term)};
}

double AerosolConstituent::depth_above(const Band& band, double aod500, double altitude_km) const {
  const Depth depth = between(altitude_km, profile_->altitude_km.back(), band.wavelength_nm, aod500);
  return depth.haze + depth.stratospheric;
}

std::vector<Scatterer> AerosolConstituent::scatterers(double wavelength_nm, double aod500) const {
  if (aod500 <= 0.0) return {};
  const AerosolOptics& stratospheric = optics_->stratospheric_optics();
  // One scatterer as long as both parts are made of the same particles.
  const bool apart = optics_->stratosphere && has_stratospheric_part();
  Scatterer in_haze{optics_->phase_function(wavelength_nm), {}};
  Scatterer above{apart ? stratospheric.phase_function(wavelength_nm) : in_haze.phase, {}};
  const double haze_albedo = optics_->single_scattering_albedo_at(wavelength_nm);
  const double stratospheric_albedo = stratospheric.single_scattering_albedo_at(wavelength_nm);
  for (std::size_t layer = 0; layer + 1 < levels_km_.size(); ++layer) {
    const Depth depth = between(levels_km_[layer], levels_km_[layer + 1], wavelength_nm, aod500);
    in_haze.scattering_depth.push_back(haze_albedo * (apart ? depth.haze : depth.haze + depth.stratospheric));
    if (apart) above.scattering_depth.push_back(stratospheric_albedo * depth.stratospheric);
  }
  std::vector<Scatterer> scatterers{std::move(in_haze)};
  if (apart) scatterers.push_back(std::move(above));
  return scatterers;
}

double AerosolConstituent::depth(double wavelength_nm, double aod500) const {
  return has_stratospheric_part() ? optics_->depth(wavelength_nm, aod500)
                                  : aod500 * optics_->relative_depth(wavelength_nm);
}

double AerosolConstituent::aod500_of_depth(double wavelength_nm, double depth) const {
  return has_stratospheric_part() ? optics_->aod500_of_depth(wavelength_nm, depth)
                                  : depth / optics_->relative_depth(wavelength_nm);
}

double AerosolConstituent::extinction_at_ground_per_km(double wavelength_nm, double aod500) const {
  if (aod500 <= 0.0) return 0.0;
  const double top_km = profile_->altitude_km.back();
  if (!has_stratospheric_part()) {
    const std::vector<double>& given = profile_->relative_aerosol_extinction;
    return aod500 * optics_->relative_depth(wavelength_nm) * 1000.0 * given.front() /
           gas_column_per_m2(*profile_, {"aerosol", given}, 0.0, top_km);
  }
  const double stratospheric500 = aod500 * optics_->shape.stratospheric_share(aod500);
  return (aod500 - stratospheric500) * optics_->relative_depth(wavelength_nm) *
             optics_->shape.haze_density_per_km(0.0, top_km) +
         stratospheric500 * optics_->stratospheric_optics().relative_depth(wavelength_nm) *
             optics_->shape.stratospheric_density_per_km(0.0, top_km);
}

nlohmann::ordered_json AerosolConstituent::describe() const {
  nlohmann::ordered_json json = aerosol_json(*optics_);
  if (!has_stratospheric_part()) json["where"] = "as the profile's relative_aerosol_extinction says";
  return json;
}

}  // namespace skylut
