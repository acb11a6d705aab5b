#include "skylut/optics/air.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/optics/ozone.hpp"
#include "skylut/optics/rayleigh.hpp"

namespace skylut {

namespace {

// Layer boundaries: fine where the haze and the observers are, coarse where little air is left.
std::vector<double> layer_levels_km(double top_km) {
  std::vector<double> levels{0.0, 0.1};
  for (double z = 0.25; z < 7.0; z += 0.25) levels.push_back(z);
  for (double z = 7.0; z < 35.0; z += 0.5) levels.push_back(z);
  for (double z = 35.0; z < 50.0; z += 2.5) levels.push_back(z);
  for (double z : {50.0, 55.0, 60.0, 70.0, 80.0, 100.0}) levels.push_back(z);
  if (top_km > levels.back()) levels.push_back(top_km);
  return levels;
}

void check_options(const AirOptions& options) {
  options.ground_albedo.validate();
  if (options.ozone_du && !(*options.ozone_du >= 0.0 && *options.ozone_du <= 1000.0))
    throw InputError("ozone column {} DU: must lie within 0-1000 DU", *options.ozone_du);
  if (!(options.gravity_m_s2 >= 9.7 && options.gravity_m_s2 <= 9.9))
    throw InputError("gravity {} m/s2: must lie within 9.7-9.9 m/s2", options.gravity_m_s2);
  if (!(options.planet_radius_km >= 1000.0))
    throw InputError("planet radius {} km: must be 1000 km or more", options.planet_radius_km);
  options.aerosol.validate();
}

}  // namespace

Air::Air(Profile profile, AirOptions options) : profile_(std::move(profile)), options_(std::move(options)) {
  check_options(options_);
  if (options_.ozone_du) scale_gas_column(profile_, "ozone", *options_.ozone_du * kDobsonUnit_per_m2);
  carbon_dioxide_fraction_ =
      profile_.gas("carbon_dioxide")->density_per_m3.front() / air_state(profile_, 0.0).density_per_m3;

  shells_.planet_radius_km = options_.planet_radius_km;
  shells_.levels_km = layer_levels_km(profile_.altitude_km.back());
  absorbers_.push_back({{"ozone", load_ozone_cross_section()}, {}});
  for (std::size_t layer = 0; layer + 1 < shells_.levels_km.size(); ++layer) {
    const double lower_km = shells_.levels_km[layer];
    const double upper_km = shells_.levels_km[layer + 1];
    air_per_m2_.push_back(air_between_per_m2(lower_km, upper_km));
    for (GasLayers& absorber : absorbers_)
      absorber.nodes.push_back(gas_nodes(absorber.gas.name, lower_km, upper_km));
  }
}

// The air at altitude z under gravity g is that of the profile at z g/g0.
double Air::air_between_per_m2(double lower_km, double upper_km) const {
  const double stretch = options_.gravity_m_s2 / kStandardGravity_m_s2;
  const double top_km = profile_.altitude_km.back();
  return air_column_per_m2(profile_, std::min(lower_km * stretch, top_km),
                           std::min(upper_km * stretch, top_km)) /
         stretch;
}

std::vector<Air::ColumnNode> Air::gas_nodes(const std::string& name, double lower_km, double upper_km) const {
  static const Quadrature rule = gauss_legendre(6, 0.0, 1.0);
  const GasProfile& gas = *profile_.gas(name);
  std::vector<double> edges{lower_km};
  for (double z : profile_.altitude_km)
    if (z > lower_km && z < upper_km) edges.push_back(z);
  edges.push_back(upper_km);
  std::vector<ColumnNode> nodes;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const double thickness_km = edges[i + 1] - edges[i];
      const double z = edges[i] + rule.node[k] * thickness_km;
      nodes.push_back({air_state(profile_, z).temperature_K,
                       1000.0 * thickness_km * rule.weight[k] *
                           interpolate_by_altitude(profile_, gas.density_per_m3, z)});
    }
  return nodes;
}

double Air::absorption_depth(const CrossSection& cross_section, const std::vector<ColumnNode>& nodes,
                             double wavelength_nm) {
  double depth = 0.0;
  for (const ColumnNode& node : nodes)
    depth += node.column_per_m2 * cross_section.at_m2(wavelength_nm, node.temperature_K);
  return depth;
}

double Air::aerosol_fraction(double lower_km, double upper_km, double aod500) const {
  const double top_km = shells_.levels_km.back();
  if (!profile_.relative_aerosol_extinction.empty()) {
    const GasProfile extinction{"aerosol", profile_.relative_aerosol_extinction};
    return gas_column_per_m2(profile_, extinction, lower_km, upper_km) /
           gas_column_per_m2(profile_, extinction, 0.0, top_km);
  }
  return options_.aerosol.shape.part_between(lower_km, upper_km, top_km, aod500);
}

void Air::check(double wavelength_nm, double aod500) {
  if (!(wavelength_nm >= 300.0 && wavelength_nm <= 1000.0))
    throw InputError("wavelength {} nm: must lie within 300-1000 nm", wavelength_nm);
  if (!(aod500 >= 0.0) || !std::isfinite(aod500))
    throw InputError("aerosol optical depth {}: must be finite and not negative", aod500);
}

OpticalColumn Air::column(double wavelength_nm, double aod500) const {
  check(wavelength_nm, aod500);
  const double rayleigh_m2 = rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_);
  const double aerosol_depth = aod500 * options_.aerosol.relative_depth(wavelength_nm);
  const double aerosol_albedo = options_.aerosol.single_scattering_albedo_at(wavelength_nm);

  OpticalColumn column;
  column.ground_albedo = options_.ground_albedo.at(wavelength_nm);
  Scatterer molecules{
      std::make_shared<RayleighPhaseFunction>(depolarisation_of_air(wavelength_nm, carbon_dioxide_fraction_)),
      {}};
  Scatterer aerosol{options_.aerosol.phase_function(wavelength_nm), {}};
  for (std::size_t layer = 0; layer < air_per_m2_.size(); ++layer) {
    const double scattering = rayleigh_m2 * air_per_m2_[layer];
    double extinction = scattering;
    molecules.scattering_depth.push_back(scattering);
    for (const GasLayers& absorber : absorbers_)
      extinction += absorption_depth(absorber.gas.cross_section, absorber.nodes[layer], wavelength_nm);
    if (aod500 > 0.0) {
      const double haze =
          aerosol_depth * aerosol_fraction(shells_.levels_km[layer], shells_.levels_km[layer + 1], aod500);
      extinction += haze;
      aerosol.scattering_depth.push_back(aerosol_albedo * haze);
    }
    column.extinction_depth.push_back(extinction);
  }
  column.scatterers.push_back(std::move(molecules));
  if (aod500 > 0.0) column.scatterers.push_back(std::move(aerosol));
  return column;
}

std::vector<ConstituentDepth> Air::optical_depths(double wavelength_nm, double aod500,
                                                  double altitude_km) const {
  check(wavelength_nm, aod500);
  const double top_km = shells_.levels_km.back();
  if (!(altitude_km >= 0.0 && altitude_km <= top_km))
    throw InputError("altitude {} km: must lie within 0-{} km", altitude_km, top_km);
  std::vector<ConstituentDepth> depths;
  depths.push_back({"rayleigh", rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
                                    air_between_per_m2(altitude_km, top_km)});
  for (const GasLayers& absorber : absorbers_)
    depths.push_back({absorber.gas.name,
                      absorption_depth(absorber.gas.cross_section,
                                       gas_nodes(absorber.gas.name, altitude_km, top_km), wavelength_nm)});
  const double aerosol = aod500 > 0.0 ? aod500 * options_.aerosol.relative_depth(wavelength_nm) *
                                            aerosol_fraction(altitude_km, top_km, aod500)
                                      : 0.0;
  depths.push_back({"aerosol", aerosol});
  return depths;
}

double Air::rayleigh_depth(double wavelength_nm) const {
  check(wavelength_nm, 0.0);
  return rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
         air_between_per_m2(0.0, shells_.levels_km.back());
}

double Air::rayleigh_extinction_at_ground_per_km(double wavelength_nm) const {
  check(wavelength_nm, 0.0);
  return 1000.0 * rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
         air_state(profile_, 0.0).density_per_m3;
}

double Air::aerosol_extinction_at_ground_per_km(double wavelength_nm, double aod500) const {
  check(wavelength_nm, aod500);
  if (aod500 <= 0.0) return 0.0;
  const double top_km = shells_.levels_km.back();
  const std::vector<double>& given = profile_.relative_aerosol_extinction;
  const double per_km =
      given.empty() ? options_.aerosol.shape.density_per_km(0.0, top_km, aod500)
                    : 1000.0 * given.front() / gas_column_per_m2(profile_, {"aerosol", given}, 0.0, top_km);
  return aod500 * options_.aerosol.relative_depth(wavelength_nm) * per_km;
}

}  // namespace skylut
