#include "skylut/report/aerosol_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "skylut/scattering/aerosol_json.hpp"

namespace skylut {

namespace {

using nlohmann::ordered_json;

// The ranges for which Ångström exponents are usually published: OPAC's two, and AERONET's.
constexpr std::array<std::pair<double, double>, 3> kExponentRanges_nm{
    {{350.0, 500.0}, {500.0, 800.0}, {440.0, 870.0}}};
constexpr int kMomentsInText = 5;

std::string component_line(const AerosolComponent& component) {
  const SizeDistribution& size = component.size;
  const std::string shape =
      size.kind == SizeDistribution::Kind::lognormal
          ? fmt::format("lognormal, mode {:g} um, sigma {:g}", size.mode_radius_um, size.sigma_g)
          : fmt::format("dN/d ln r as r^-{:g}", size.exponent);
  return fmt::format("  {:<24} {:>10g} per cm3  {}, {:g}-{:g} um\n", component.name, component.number_per_cm3,
                     shape, size.r_min_um, size.r_max_um);
}

std::string shape_text(const AerosolDescription& description) {
  const AerosolShape& shape = description.shape;
  std::string haze;
  if (!shape.altitude_km.empty())
    haze = fmt::format("by a table of {} altitudes to {:g} km", shape.altitude_km.size(),
                       shape.altitude_km.back());
  else if (shape.mixed_layer_km > 0.0)
    haze = fmt::format("constant to {:g} km, above exp(-z / {:g} km)", shape.mixed_layer_km,
                       shape.haze_scale_height_km);
  else
    haze = fmt::format("exp(-z / {:g} km)", shape.haze_scale_height_km);
  if (!description.shape_source.empty()) haze += " (" + description.shape_source + ")";
  return fmt::format(
      "\nVertical shape\n  haze           {}\n"
      "  stratosphere   up to {:g} at 500 nm of {}, Gaussian at {:g} km, standard deviation {:g} km\n",
      haze, shape.stratospheric_aod500,
      description.stratosphere.empty() ? description.name : description.stratosphere,
      shape.stratospheric_centre_km, shape.stratospheric_width_km);
}

}  // namespace

std::string aerosol_text(const AerosolOptics& optics) {
  const AerosolDescription& description = *optics.description;
  std::string text =
      fmt::format("{}: {}\n  source: {}\n", description.name, description.description, description.source);
  if (description.humidity_percent)
    text += fmt::format("  relative humidity {:g} %\n", *description.humidity_percent);
  if (!description.components.empty()) text += "\nParticles\n";
  for (const AerosolComponent& component : description.components) text += component_line(component);

  text += "\n  nm    extinction  albedo   asymmetry  Legendre moments from the second\n";
  for (const double nm : optics.wavelength_nm) {
    const std::shared_ptr<const PhaseFunction> phase = optics.phase_function(nm);
    text += fmt::format("{:6g}  {:8.5f}   {:.5f}  {:.5f}   ", nm, optics.relative_depth(nm),
                        optics.single_scattering_albedo_at(nm), optics.asymmetry_at(nm));
    for (int l = 2; l < 2 + kMomentsInText; ++l) text += fmt::format(" {:.5f}", phase->moment(l));
    text += "\n";
  }
  text += "\nAngstrom exponents\n";
  for (const auto& [first, second] : kExponentRanges_nm)
    text += fmt::format("  {:g}-{:g} nm   {:.3f}\n", first, second,
                        optics.angstrom_exponent_between(first, second));
  return text + shape_text(description);
}

ordered_json aerosol_report_json(const AerosolOptics& optics) {
  ordered_json json = aerosol_json(optics);
  for (const std::shared_ptr<const TabulatedPhaseFunction>& phase : optics.phase)
    json["moments"].push_back(phase->moments());
  for (const auto& [first, second] : kExponentRanges_nm)
    json["angstrom_exponent"][fmt::format("{:g}-{:g}", first, second)] =
        optics.angstrom_exponent_between(first, second);
  return json;
}

}  // namespace skylut
