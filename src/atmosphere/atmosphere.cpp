#include "skylut/atmosphere/atmosphere.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "aerosol_constituent.hpp"
#include "gas_constituent.hpp"
#include "line_constituent.hpp"
#include "rayleigh_constituent.hpp"
#include "skylut/atmosphere/gas_cross_sections.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/scattering/rayleigh.hpp"

namespace skylut {

namespace {

// Layer boundaries: fine where the haze and the observers are, coarse where little air is left.
std::vector<double> layer_levels_km(double top_km) {
  std::vector<double> levels{0.0, 0.1};
  for (int i = 1; i < 28; ++i) levels.push_back(0.25 * i);  // to 6.75
  for (int i = 14; i < 70; ++i) levels.push_back(0.5 * i);  // 7 to 34.5
  for (int i = 14; i < 20; ++i) levels.push_back(2.5 * i);  // 35 to 47.5
  for (double z : {50.0, 55.0, 60.0, 70.0, 80.0, 100.0}) levels.push_back(z);
  if (top_km > levels.back()) levels.push_back(top_km);
  return levels;
}

// The boundaries of constituents join the levels; one that comes closer than a metre to another is that one.
void add_boundaries(const std::vector<double>& boundaries_km, std::vector<double>& levels_km) {
  constexpr double kSameLevel_km = 1e-3;
  for (const double boundary : boundaries_km) {
    if (!(boundary >= 0.0 && boundary <= levels_km.back()))
      throw InputError("boundary of a constituent at {} km: must lie within 0 to {} km", boundary,
                       levels_km.back());
    const auto above = std::lower_bound(levels_km.begin(), levels_km.end(), boundary);
    const bool known = (above != levels_km.end() && *above - boundary < kSameLevel_km) ||
                       (above != levels_km.begin() && boundary - *(above - 1) < kSameLevel_km);
    if (!known) levels_km.insert(above, boundary);
  }
}

void check_options(const AtmosphereOptions& options) {
  options.ground_albedo.validate();
  if (options.ozone_du) require_within("ozone column", *options.ozone_du, domain::kOzone_DU);
  if (options.no2_du) require_within("nitrogen dioxide column", *options.no2_du, domain::kNitrogenDioxide_DU);
  if (options.water_cm) require_within("precipitable water", *options.water_cm, domain::kWater_cm);
  if (options.surface_pressure_hPa)
    require_within("surface pressure", *options.surface_pressure_hPa, domain::kSurfacePressure_hPa);
  require_within("gravity", options.gravity_m_s2, domain::kGravity_m_s2);
  require_within("planet radius", options.planet_radius_km, domain::kPlanetRadius_km);
  options.aerosol.validate();
}

void check_band(const Band& band) { require_within("band width", band.width_nm, domain::kBand_nm); }

// The profile with the columns and the pressure that the options ask for.
Profile scaled_profile(Profile profile, const AtmosphereOptions& options) {
  if (options.surface_pressure_hPa) scale_surface_pressure(profile, *options.surface_pressure_hPa);
  if (options.ozone_du) scale_gas_column(profile, "ozone", *options.ozone_du * kDobsonUnit_per_m2);
  if (options.no2_du) scale_gas_column(profile, "nitrogen_dioxide", *options.no2_du * kDobsonUnit_per_m2);
  if (options.water_cm)
    scale_gas_column(profile, "water_vapour", *options.water_cm * water_molecules_per_m2_cm());
  return profile;
}

}  // namespace

Atmosphere::Atmosphere(const Context& context, Profile profile, AtmosphereOptions options,
                       std::vector<std::unique_ptr<Constituent>> more)
    : options_(std::move(options)) {
  check_options(options_);
  profile_ = std::make_shared<const Profile>(scaled_profile(std::move(profile), options_));

  auto rayleigh = std::make_unique<RayleighConstituent>(profile_, options_.gravity_m_s2);
  auto aerosol =
      std::make_unique<AerosolConstituent>(profile_, std::make_shared<const AerosolOptics>(options_.aerosol));
  rayleigh_ = rayleigh.get();
  aerosol_ = aerosol.get();
  const auto gas = [&](AbsorbingGas absorbing) {
    constituents_.push_back(std::make_unique<GasConstituent>(profile_, std::move(absorbing)));
  };
  const auto lines = [&](const char* gas_name, LineAbsorption absorption) {
    constituents_.push_back(std::make_unique<LineConstituent>(profile_, gas_name, std::move(absorption)));
  };
  constituents_.push_back(std::move(rayleigh));
  gas({"ozone", "ozone", load_ozone_cross_section(context)});
  gas({"no2", "nitrogen_dioxide", load_nitrogen_dioxide_cross_section(context)});
  gas({"o2_o2", "oxygen", load_oxygen_pair_cross_section(context), true});
  lines("oxygen", load_oxygen_lines(context));
  lines("water_vapour", load_water_lines(context));
  constituents_.push_back(std::move(aerosol));
  for (std::unique_ptr<Constituent>& constituent : more) {
    for (const std::unique_ptr<Constituent>& known : constituents_)
      if (known->name() == constituent->name())
        throw InputError("constituent '{}': is in this atmosphere already, must have a name of its own",
                         constituent->name());
    constituents_.push_back(std::move(constituent));
  }

  shells_.planet_radius_km = options_.planet_radius_km;
  shells_.levels_km = layer_levels_km(profile_->altitude_km.back());
  for (const std::unique_ptr<Constituent>& constituent : constituents_)
    add_boundaries(constituent->boundaries_km(), shells_.levels_km);
  for (const std::unique_ptr<Constituent>& constituent : constituents_)
    constituent->set_levels(shells_.levels_km);
  if (options_.refraction)
    for (const double level_km : shells_.levels_km)
      shells_.refractivity.push_back(rayleigh_->refractivity(kRefractionWavelength_nm, level_km));
}

Shells Atmosphere::shells_at(double wavelength_nm) const {
  require_within("wavelength", wavelength_nm, domain::kWavelength_nm);
  Shells shells = shells_;
  const double share =
      rayleigh_->refractivity(wavelength_nm, 0.0) / rayleigh_->refractivity(kRefractionWavelength_nm, 0.0);
  for (double& refractivity : shells.refractivity) refractivity *= share;
  return shells;
}

Atmosphere::~Atmosphere() = default;
Atmosphere::Atmosphere(Atmosphere&&) noexcept = default;
Atmosphere& Atmosphere::operator=(Atmosphere&&) noexcept = default;

void Atmosphere::check(double wavelength_nm, double aod500) const {
  require_within("wavelength", wavelength_nm, domain::kWavelength_nm);
  if (!(aod500 >= 0.0) || !std::isfinite(aod500))
    throw InputError("aerosol optical depth {}: must be finite and not negative", aod500);
}

// Scatterers and extinction 0.
OpticalColumn Atmosphere::scattering_column(double wavelength_nm, double aod500) const {
  OpticalColumn column;
  column.extinction_depth.assign(shells_.levels_km.size() - 1, 0.0);
  for (const std::unique_ptr<Constituent>& constituent : constituents_)
    for (Scatterer& scatterer : constituent->scatterers(wavelength_nm, aod500))
      column.scatterers.push_back(std::move(scatterer));
  return column;
}

OpticalColumn Atmosphere::column(double wavelength_nm, double aod500) const {
  check(wavelength_nm, aod500);
  OpticalColumn column = scattering_column(wavelength_nm, aod500);
  column.ground_albedo = options_.ground_albedo.at(wavelength_nm);
  for (const std::unique_ptr<Constituent>& constituent : constituents_) {
    if (!constituent->is_smooth()) continue;
    const std::vector<ExtinctionTerm> terms =
        constituent->extinction({.wavelength_nm = wavelength_nm}, aod500, BandTerms::few);
    for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer)
      column.extinction_depth[layer] += terms.front().depth[layer];
  }
  return column;
}

std::vector<ConstituentExtinction> Atmosphere::extinctions(const Band& band, double aod500) const {
  check(band.wavelength_nm, aod500);
  check_band(band);
  std::vector<ConstituentExtinction> extinctions;
  for (const std::unique_ptr<Constituent>& constituent : constituents_)
    extinctions.push_back({constituent->name(), constituent->extinction(band, aod500, BandTerms::all)});
  return extinctions;
}

std::vector<BandColumn> Atmosphere::band_columns(const Band& band, double aod500) const {
  check(band.wavelength_nm, aod500);
  check_band(band);
  std::vector<BandColumn> columns{{1.0, scattering_column(band.wavelength_nm, aod500)}};
  columns.front().column.ground_albedo = options_.ground_albedo.at(band.wavelength_nm, band.width_nm);
  for (const std::unique_ptr<Constituent>& constituent : constituents_) {
    const std::vector<ExtinctionTerm> terms = constituent->extinction(band, aod500, BandTerms::few);
    std::vector<BandColumn> product;
    for (const BandColumn& before : columns)
      for (const ExtinctionTerm& term : terms) {
        product.push_back(before);
        product.back().weight *= term.weight;
        for (std::size_t layer = 0; layer < term.depth.size(); ++layer)
          product.back().column.extinction_depth[layer] += term.depth[layer];
      }
    columns = std::move(product);
  }
  return columns;
}

std::vector<ConstituentDepth> Atmosphere::optical_depths(const Band& band, double aod500,
                                                         double altitude_km) const {
  check(band.wavelength_nm, aod500);
  check_band(band);
  require_within("altitude", altitude_km, {0.0, shells_.levels_km.back(), "km"});
  std::vector<ConstituentDepth> depths;
  for (const std::unique_ptr<Constituent>& constituent : constituents_)
    depths.push_back({constituent->name(), constituent->depth_above(band, aod500, altitude_km)});
  return depths;
}

double Atmosphere::rayleigh_depth(double wavelength_nm) const {
  check(wavelength_nm, 0.0);
  return rayleigh_->depth_above({.wavelength_nm = wavelength_nm}, 0.0, 0.0);
}

double Atmosphere::rayleigh_extinction_at_ground_per_km(double wavelength_nm) const {
  check(wavelength_nm, 0.0);
  return rayleigh_->extinction_at_ground_per_km(wavelength_nm);
}

double Atmosphere::aerosol_extinction_at_ground_per_km(double wavelength_nm, double aod500) const {
  check(wavelength_nm, aod500);
  return aerosol_->extinction_at_ground_per_km(wavelength_nm, aod500);
}

double Atmosphere::aerosol_depth(double wavelength_nm, double aod500) const {
  return aerosol_->depth(wavelength_nm, aod500);
}

double Atmosphere::aod500_of_aerosol_depth(double wavelength_nm, double depth) const {
  return aerosol_->aod500_of_depth(wavelength_nm, depth);
}

double Atmosphere::depolarisation(double wavelength_nm) const {
  return depolarisation_of_air(wavelength_nm, rayleigh_->carbon_dioxide_fraction());
}

nlohmann::ordered_json Atmosphere::describe() const {
  const auto column = [&](const char* gas_name, double unit_per_m2) {
    const GasProfile* gas = profile_->gas(gas_name);
    return gas == nullptr
               ? 0.0
               : gas_column_per_m2(*profile_, *gas, 0.0, profile_->altitude_km.back()) / unit_per_m2;
  };
  nlohmann::ordered_json json{{"ground_albedo", options_.ground_albedo.describe()},
                              {"surface_pressure_hPa", profile_->pressure_hPa.front()},
                              {"ozone_du", column("ozone", kDobsonUnit_per_m2)},
                              {"no2_du", column("nitrogen_dioxide", kDobsonUnit_per_m2)},
                              {"water_cm", column("water_vapour", water_molecules_per_m2_cm())},
                              {"gravity_m_s2", options_.gravity_m_s2},
                              {"planet_radius_km", options_.planet_radius_km},
                              {"levels_km", shells_.levels_km}};
  if (options_.refraction)
    json["refraction"] = {{"refractivity_at_ground", shells_.refractivity.front()},
                          {"wavelength_nm", kRefractionWavelength_nm},
                          {"source", RayleighConstituent::refractivity_source()}};
  for (const std::unique_ptr<Constituent>& constituent : constituents_)
    json[constituent->name()] = constituent->describe();
  return json;
}

}  // namespace skylut
