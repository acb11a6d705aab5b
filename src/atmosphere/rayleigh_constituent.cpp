#include "rayleigh_constituent.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "air_column.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/scattering/rayleigh.hpp"

namespace skylut {

RayleighConstituent::RayleighConstituent(std::shared_ptr<const Profile> profile, double gravity_m_s2)
    : profile_(std::move(profile)),
      gravity_m_s2_(gravity_m_s2),
      carbon_dioxide_fraction_(profile_->gas("carbon_dioxide")->density_per_m3.front() /
                               air_state(*profile_, 0.0).density_per_m3) {}

void RayleighConstituent::set_levels(const std::vector<double>& levels_km) {
  air_per_m2_.clear();
  for (std::size_t layer = 0; layer + 1 < levels_km.size(); ++layer)
    air_per_m2_.push_back(
        stretched_air_per_m2(*profile_, gravity_m_s2_, levels_km[layer], levels_km[layer + 1]));
}

std::vector<double> RayleighConstituent::depths(double wavelength_nm) const {
  const double cross_section_m2 = rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_);
  std::vector<double> depth;
  for (const double air_per_m2 : air_per_m2_) depth.push_back(cross_section_m2 * air_per_m2);
  return depth;
}

std::vector<ExtinctionTerm> RayleighConstituent::extinction(const Band& band, double, BandTerms) const {
  return {{1.0, depths(band.wavelength_nm)}};
}

double RayleighConstituent::depth_above(const Band& band, double, double altitude_km) const {
  return rayleigh_cross_section_m2(band.wavelength_nm, carbon_dioxide_fraction_) *
         stretched_air_per_m2(*profile_, gravity_m_s2_, altitude_km, profile_->altitude_km.back());
}

std::vector<Scatterer> RayleighConstituent::scatterers(double wavelength_nm, double) const {
  return {{std::make_shared<RayleighPhaseFunction>(
               depolarisation_of_air(wavelength_nm, carbon_dioxide_fraction_)),
           depths(wavelength_nm)}};
}

double RayleighConstituent::extinction_at_ground_per_km(double wavelength_nm) const {
  return 1000.0 * rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
         air_state(*profile_, 0.0).density_per_m3;
}

double RayleighConstituent::refractivity(double wavelength_nm, double altitude_km) const {
  // Stretched under another gravity, as stretched_air_per_m2.
  const double profile_km =
      std::min(altitude_km * gravity_m_s2_ / kStandardGravity_m_s2, profile_->altitude_km.back());
  const GasProfile* water = profile_->gas("water_vapour");
  const double air_per_m3 = air_state(*profile_, profile_km).density_per_m3;
  const double water_per_m3 =
      water == nullptr ? 0.0 : interpolate_by_altitude(*profile_, water->density_per_m3, profile_km);
  return refractivity_of_air(wavelength_nm, carbon_dioxide_fraction_, air_per_m3,
                             std::min(air_per_m3, water_per_m3));
}

const char* RayleighConstituent::refractivity_source() {
  return "Peck and Reeder 1972, doi:10.1364/JOSA.62.000958; water vapour Ciddor 1996, "
         "doi:10.1364/AO.35.001566";
}

nlohmann::ordered_json RayleighConstituent::describe() const {
  return {{"name", name()},
          {"cross_section", "Bodhaine et al. 1999, doi:10.1175/1520-0426(1999)016<1854:ORODC>2.0.CO;2"},
          {"carbon_dioxide_fraction", carbon_dioxide_fraction_},
          {"gravity_m_s2", gravity_m_s2_}};
}

}  // namespace skylut
