#include "skylut/atmosphere/atmosphere.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skylut/atmosphere/gas_cross_sections.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"
#include "skylut/scattering/rayleigh.hpp"

namespace skylut {

namespace {

// Reference state of the amounts in LineBand.
constexpr double kLinePressure_hPa = 1013.25;
constexpr double kLineTemperature_K = 273.15;

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

void check_options(const AtmosphereOptions& options) {
  options.ground_albedo.validate();
  if (options.ozone_du && !(*options.ozone_du >= 0.0 && *options.ozone_du <= 1000.0))
    throw InputError("ozone column {} DU: must lie within 0-1000 DU", *options.ozone_du);
  if (options.no2_du && !(*options.no2_du >= 0.0 && *options.no2_du <= 100.0))
    throw InputError("nitrogen dioxide column {} DU: must lie within 0-100 DU", *options.no2_du);
  if (options.water_cm && !(*options.water_cm >= 0.0 && *options.water_cm <= 20.0))
    throw InputError("precipitable water {} cm: must lie within 0-20 cm", *options.water_cm);
  if (options.surface_pressure_hPa &&
      !(*options.surface_pressure_hPa >= 300.0 && *options.surface_pressure_hPa <= 1100.0))
    throw InputError("surface pressure {} hPa: must lie within 300-1100 hPa", *options.surface_pressure_hPa);
  if (!(options.gravity_m_s2 >= 9.7 && options.gravity_m_s2 <= 9.9))
    throw InputError("gravity {} m/s2: must lie within 9.7-9.9 m/s2", options.gravity_m_s2);
  if (!(options.planet_radius_km >= 1000.0))
    throw InputError("planet radius {} km: must be 1000 km or more", options.planet_radius_km);
  options.aerosol.validate();
}

void check_band(double band_nm) {
  if (!(band_nm > 0.0 && band_nm <= 100.0))
    throw InputError("band width {} nm: must lie within 0-100 nm, 0 excluded", band_nm);
}

}  // namespace

Atmosphere::Atmosphere(const Context& context, Profile profile, AtmosphereOptions options)
    : profile_(std::move(profile)), options_(std::move(options)) {
  check_options(options_);
  scale_columns();
  carbon_dioxide_fraction_ =
      profile_.gas("carbon_dioxide")->density_per_m3.front() / air_state(profile_, 0.0).density_per_m3;

  shells_.planet_radius_km = options_.planet_radius_km;
  shells_.levels_km = layer_levels_km(profile_.altitude_km.back());
  absorbers_.push_back({{"ozone", "ozone", load_ozone_cross_section(context)}, {}});
  absorbers_.push_back({{"no2", "nitrogen_dioxide", load_nitrogen_dioxide_cross_section(context)}, {}});
  absorbers_.push_back({{"o2_o2", "oxygen", load_oxygen_pair_cross_section(context), true}, {}});
  line_absorbers_.push_back({"oxygen", "oxygen", load_oxygen_lines(context), {}});
  line_absorbers_.push_back({"water_vapour", "water_vapour", load_water_lines(context), {}});
  for (std::size_t layer = 0; layer + 1 < shells_.levels_km.size(); ++layer) {
    const double lower_km = shells_.levels_km[layer];
    const double upper_km = shells_.levels_km[layer + 1];
    air_per_m2_.push_back(air_between_per_m2(lower_km, upper_km));
    for (GasLayers& absorber : absorbers_)
      absorber.nodes.push_back(gas_nodes(absorber.gas.gas_name, absorber.gas.pairs, lower_km, upper_km));
    for (LineLayers& absorber : line_absorbers_)
      absorber.nodes.push_back(gas_nodes(absorber.gas_name, false, lower_km, upper_km));
  }
}

void Atmosphere::scale_columns() {
  if (options_.surface_pressure_hPa) scale_surface_pressure(profile_, *options_.surface_pressure_hPa);
  if (options_.ozone_du) scale_gas_column(profile_, "ozone", *options_.ozone_du * kDobsonUnit_per_m2);
  if (options_.no2_du) scale_gas_column(profile_, "nitrogen_dioxide", *options_.no2_du * kDobsonUnit_per_m2);
  if (options_.water_cm)
    scale_gas_column(profile_, "water_vapour", *options_.water_cm * water_molecules_per_m2_cm());
  update_quantities(profile_);
}

// The air at altitude z under gravity g is that of the profile at z g/g0.
double Atmosphere::air_between_per_m2(double lower_km, double upper_km) const {
  const double stretch = options_.gravity_m_s2 / kStandardGravity_m_s2;
  const double top_km = profile_.altitude_km.back();
  return air_column_per_m2(profile_, std::min(lower_km * stretch, top_km),
                           std::min(upper_km * stretch, top_km)) /
         stretch;
}

std::vector<Atmosphere::ColumnNode> Atmosphere::gas_nodes(const std::string& gas_name, bool pairs,
                                                          double lower_km, double upper_km) const {
  static const Quadrature rule = gauss_legendre(6, 0.0, 1.0);
  const GasProfile* gas = profile_.gas(gas_name);
  if (gas == nullptr) return {};
  std::vector<double> edges{lower_km};
  for (double z : profile_.altitude_km)
    if (z > lower_km && z < upper_km) edges.push_back(z);
  edges.push_back(upper_km);
  std::vector<ColumnNode> nodes;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const double thickness_km = edges[i + 1] - edges[i];
      const double z = edges[i] + rule.node[k] * thickness_km;
      const AirState state = air_state(profile_, z);
      const double density_per_m3 = interpolate_by_altitude(profile_, gas->density_per_m3, z);
      nodes.push_back(
          {state.temperature_K,
           1000.0 * thickness_km * rule.weight[k] * density_per_m3 * (pairs ? density_per_m3 : 1.0),
           std::log(state.pressure_hPa / kLinePressure_hPa),
           std::log(kLineTemperature_K / state.temperature_K)});
    }
  return nodes;
}

double Atmosphere::absorption_depth(const CrossSection& cross_section, const std::vector<ColumnNode>& nodes,
                                    double wavelength_nm) {
  double depth = 0.0;
  for (const ColumnNode& node : nodes)
    depth += node.column_per_m2 * cross_section.at_m2(wavelength_nm, node.temperature_K);
  return depth;
}

double Atmosphere::scaled_amount_per_m2(const LineBand& band, const std::vector<ColumnNode>& nodes) {
  double amount = 0.0;
  for (const ColumnNode& node : nodes)
    amount += node.column_per_m2 * std::exp(band.pressure_exponent * node.log_pressure +
                                            band.temperature_exponent * node.log_inverse_temperature);
  return amount;
}

Constituent Atmosphere::line_constituent(const LineLayers& absorber, double wavelength_nm, double band_nm,
                                         bool few_terms) const {
  const LineBand band = absorber.lines.band(wavelength_nm, band_nm);
  std::vector<double> amounts_per_m2;
  double whole_per_m2 = 0.0;
  for (const std::vector<ColumnNode>& layer : absorber.nodes) {
    amounts_per_m2.push_back(band.sum.size() > 1 ? scaled_amount_per_m2(band, layer) : 0.0);
    whole_per_m2 += amounts_per_m2.back();
  }
  Constituent constituent{absorber.name, {}};
  for (const Exponential& term : few_terms ? fit_exponentials(band.sum, whole_per_m2) : band.sum) {
    constituent.terms.push_back({term.weight, amounts_per_m2});
    for (double& depth : constituent.terms.back().depth) depth *= term.coefficient;
  }
  return constituent;
}

Atmosphere::AerosolDepth Atmosphere::aerosol_between(double lower_km, double upper_km, double wavelength_nm,
                                                     double aod500) const {
  if (aod500 <= 0.0) return {0.0, 0.0};
  const AerosolOptics& aerosol = options_.aerosol;
  const double top_km = shells_.levels_km.back();
  if (!has_stratospheric_layer()) {
    const GasProfile extinction{"aerosol", profile_.relative_aerosol_extinction};
    return {aod500 * aerosol.relative_depth(wavelength_nm) *
                gas_column_per_m2(profile_, extinction, lower_km, upper_km) /
                gas_column_per_m2(profile_, extinction, 0.0, top_km),
            0.0};
  }
  const double layer500 = aod500 * aerosol.shape.stratospheric_share(aod500);
  return {(aod500 - layer500) * aerosol.relative_depth(wavelength_nm) *
              aerosol.shape.haze_between(lower_km, upper_km, top_km),
          layer500 * aerosol.stratospheric_optics().relative_depth(wavelength_nm) *
              aerosol.shape.layer_between(lower_km, upper_km, top_km)};
}

void Atmosphere::check(double wavelength_nm, double aod500) {
  if (!(wavelength_nm >= 300.0 && wavelength_nm <= 1000.0))
    throw InputError("wavelength {} nm: must lie within 300-1000 nm", wavelength_nm);
  if (!(aod500 >= 0.0) || !std::isfinite(aod500))
    throw InputError("aerosol optical depth {}: must be finite and not negative", aod500);
}

std::vector<Constituent> Atmosphere::smooth_constituents(double wavelength_nm, double aod500) const {
  const std::size_t layers = air_per_m2_.size();
  const auto constituent = [&](std::string name, const auto& depth_of_layer) {
    AbsorptionTerm term{1.0, std::vector<double>(layers)};
    for (std::size_t layer = 0; layer < layers; ++layer) term.depth[layer] = depth_of_layer(layer);
    return Constituent{std::move(name), {std::move(term)}};
  };
  std::vector<Constituent> result;
  const double rayleigh_m2 = rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_);
  result.push_back(
      constituent("rayleigh", [&](std::size_t layer) { return rayleigh_m2 * air_per_m2_[layer]; }));
  for (const GasLayers& absorber : absorbers_)
    result.push_back(constituent(absorber.gas.name, [&](std::size_t layer) {
      return absorption_depth(absorber.gas.cross_section, absorber.nodes[layer], wavelength_nm);
    }));
  result.push_back(constituent("aerosol", [&](std::size_t layer) {
    const AerosolDepth depth =
        aerosol_between(shells_.levels_km[layer], shells_.levels_km[layer + 1], wavelength_nm, aod500);
    return depth.haze + depth.layer;
  }));
  return result;
}

OpticalColumn Atmosphere::scattering_column(double wavelength_nm,
                                            const std::vector<Constituent>& constituents,
                                            double aod500) const {
  OpticalColumn column;
  column.ground_albedo = options_.ground_albedo.at(wavelength_nm);
  column.extinction_depth.assign(air_per_m2_.size(), 0.0);
  column.scatterers.push_back({std::make_shared<RayleighPhaseFunction>(
                                   depolarisation_of_air(wavelength_nm, carbon_dioxide_fraction_)),
                               constituents.front().terms.front().depth});
  if (aod500 > 0.0) add_aerosol(wavelength_nm, aod500, column);
  return column;
}

void Atmosphere::add_aerosol(double wavelength_nm, double aod500, OpticalColumn& column) const {
  const AerosolOptics& aerosol = options_.aerosol;
  const AerosolOptics& layer = aerosol.stratospheric_optics();
  // One scatterer as long as both are made of the same particles.
  const bool apart = aerosol.stratosphere && has_stratospheric_layer();
  Scatterer in_haze{aerosol.phase_function(wavelength_nm), {}};
  Scatterer in_layer{apart ? layer.phase_function(wavelength_nm) : in_haze.phase, {}};
  const double haze_albedo = aerosol.single_scattering_albedo_at(wavelength_nm);
  const double layer_albedo = layer.single_scattering_albedo_at(wavelength_nm);
  for (std::size_t i = 0; i < air_per_m2_.size(); ++i) {
    const AerosolDepth depth =
        aerosol_between(shells_.levels_km[i], shells_.levels_km[i + 1], wavelength_nm, aod500);
    in_haze.scattering_depth.push_back(haze_albedo * (apart ? depth.haze : depth.haze + depth.layer));
    if (apart) in_layer.scattering_depth.push_back(layer_albedo * depth.layer);
  }
  column.scatterers.push_back(std::move(in_haze));
  if (apart) column.scatterers.push_back(std::move(in_layer));
}

OpticalColumn Atmosphere::column(double wavelength_nm, double aod500) const {
  check(wavelength_nm, aod500);
  const std::vector<Constituent> constituents = smooth_constituents(wavelength_nm, aod500);
  OpticalColumn column = scattering_column(wavelength_nm, constituents, aod500);
  for (const Constituent& constituent : constituents)
    for (std::size_t layer = 0; layer < air_per_m2_.size(); ++layer)
      column.extinction_depth[layer] += constituent.terms.front().depth[layer];
  return column;
}

std::vector<Constituent> Atmosphere::all_constituents(double wavelength_nm, double band_nm, double aod500,
                                                      bool few_terms) const {
  check(wavelength_nm, aod500);
  check_band(band_nm);
  std::vector<Constituent> constituents = smooth_constituents(wavelength_nm, aod500);
  for (const LineLayers& absorber : line_absorbers_)
    constituents.insert(constituents.end() - 1,
                        line_constituent(absorber, wavelength_nm, band_nm, few_terms));
  return constituents;
}

std::vector<Constituent> Atmosphere::constituents(double wavelength_nm, double band_nm, double aod500) const {
  return all_constituents(wavelength_nm, band_nm, aod500, false);
}

std::vector<ColumnTerm> Atmosphere::band_columns(double wavelength_nm, double band_nm, double aod500) const {
  const std::vector<Constituent> constituents = all_constituents(wavelength_nm, band_nm, aod500, true);
  std::vector<ColumnTerm> columns{{1.0, scattering_column(wavelength_nm, constituents, aod500)}};
  columns.front().column.ground_albedo = options_.ground_albedo.at(wavelength_nm, band_nm);
  for (const Constituent& constituent : constituents) {
    std::vector<ColumnTerm> product;
    for (const ColumnTerm& before : columns)
      for (const AbsorptionTerm& term : constituent.terms) {
        product.push_back(before);
        product.back().weight *= term.weight;
        for (std::size_t layer = 0; layer < air_per_m2_.size(); ++layer)
          product.back().column.extinction_depth[layer] += term.depth[layer];
      }
    columns = std::move(product);
  }
  return columns;
}

std::vector<ConstituentDepth> Atmosphere::optical_depths(double wavelength_nm, double aod500,
                                                         double altitude_km, double band_nm) const {
  check(wavelength_nm, aod500);
  check_band(band_nm);
  const double top_km = shells_.levels_km.back();
  if (!(altitude_km >= 0.0 && altitude_km <= top_km))
    throw InputError("altitude {} km: must lie within 0-{} km", altitude_km, top_km);
  std::vector<ConstituentDepth> depths;
  depths.push_back({"rayleigh", rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
                                    air_between_per_m2(altitude_km, top_km)});
  for (const GasLayers& absorber : absorbers_)
    depths.push_back({absorber.gas.name, absorption_depth(absorber.gas.cross_section,
                                                          gas_nodes(absorber.gas.gas_name, absorber.gas.pairs,
                                                                    altitude_km, top_km),
                                                          wavelength_nm)});
  for (const LineLayers& absorber : line_absorbers_) {
    const LineBand band = absorber.lines.band(wavelength_nm, band_nm);
    const double amount =
        scaled_amount_per_m2(band, gas_nodes(absorber.gas_name, false, altitude_km, top_km));
    depths.push_back({absorber.name, std::max(0.0, -std::log(transmittance(band.sum, amount)))});
  }
  const AerosolDepth aerosol = aerosol_between(altitude_km, top_km, wavelength_nm, aod500);
  depths.push_back({"aerosol", aerosol.haze + aerosol.layer});
  return depths;
}

double Atmosphere::rayleigh_depth(double wavelength_nm) const {
  check(wavelength_nm, 0.0);
  return rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
         air_between_per_m2(0.0, shells_.levels_km.back());
}

double Atmosphere::rayleigh_extinction_at_ground_per_km(double wavelength_nm) const {
  check(wavelength_nm, 0.0);
  return 1000.0 * rayleigh_cross_section_m2(wavelength_nm, carbon_dioxide_fraction_) *
         air_state(profile_, 0.0).density_per_m3;
}

double Atmosphere::aerosol_extinction_at_ground_per_km(double wavelength_nm, double aod500) const {
  check(wavelength_nm, aod500);
  if (aod500 <= 0.0) return 0.0;
  const AerosolOptics& aerosol = options_.aerosol;
  const double top_km = shells_.levels_km.back();
  if (!has_stratospheric_layer()) {
    const std::vector<double>& given = profile_.relative_aerosol_extinction;
    return aod500 * aerosol.relative_depth(wavelength_nm) * 1000.0 * given.front() /
           gas_column_per_m2(profile_, {"aerosol", given}, 0.0, top_km);
  }
  const double layer500 = aod500 * aerosol.shape.stratospheric_share(aod500);
  return (aod500 - layer500) * aerosol.relative_depth(wavelength_nm) *
             aerosol.shape.haze_density_per_km(0.0, top_km) +
         layer500 * aerosol.stratospheric_optics().relative_depth(wavelength_nm) *
             aerosol.shape.layer_density_per_km(0.0, top_km);
}

double Atmosphere::aerosol_depth(double wavelength_nm, double aod500) const {
  return has_stratospheric_layer() ? options_.aerosol.depth(wavelength_nm, aod500)
                                   : aod500 * options_.aerosol.relative_depth(wavelength_nm);
}

double Atmosphere::aod500_of_aerosol_depth(double wavelength_nm, double depth) const {
  return has_stratospheric_layer() ? options_.aerosol.aod500_of_depth(wavelength_nm, depth)
                                   : depth / options_.aerosol.relative_depth(wavelength_nm);
}

}  // namespace skylut
