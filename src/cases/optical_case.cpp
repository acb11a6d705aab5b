#include "skylut/cases/optical_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using Json = nlohmann::ordered_json;

// Moments are written until they add less than this to the phase function, and no more than so many.
constexpr double kLeastTerm = 1e-7;
constexpr int kMostMoments = 4000;

BandColumn chosen_term(const Atmosphere& air, const OpticalCaseRequest& request) {
  std::vector<BandColumn> terms = air.band_columns({request.wavelength_nm, request.band_nm}, request.aod500);
  const int count = static_cast<int>(terms.size());
  if (!request.absorption_term && count > 1) {
    std::string list;
    for (int i = 0; i < count; ++i) {
      double depth = 0.0;
      for (const double layer : terms[static_cast<std::size_t>(i)].column.extinction_depth) depth += layer;
      list += fmt::format("{}{} (weight {:.4g}, optical depth {:.4g})", i == 0 ? "" : ", ", i + 1,
                          terms[static_cast<std::size_t>(i)].weight, depth);
    }
    throw InputError("{} nm: lines absorb here, choose --absorption-term from {}", request.wavelength_nm,
                     list);
  }
  const int term = request.absorption_term.value_or(1);
  if (term < 1 || term > count)
    throw InputError("--absorption-term {}: {} nm has {}, must lie within 1 to {}", term,
                     request.wavelength_nm, count == 1 ? "one term" : fmt::format("{} terms", count), count);
  return std::move(terms[static_cast<std::size_t>(term - 1)]);
}

// Moment l of what all the scatterers together scatter in a layer.
double mixed_moment(std::span<const Scatterer> scatterers, std::size_t layer, double scattering, int l) {
  double sum = 0.0;
  for (const Scatterer& scatterer : scatterers)
    if (scatterer.scattering_depth[layer] > 0.0)
      sum += scatterer.scattering_depth[layer] / scattering * scatterer.phase->moment(l);
  return sum;
}

Json mixed_moments(std::span<const Scatterer> scatterers, std::size_t layer, double scattering) {
  std::vector<double> moments;
  std::size_t wanted = 0;
  // A moment may be small by chance: some more must be, too.
  constexpr std::size_t kMoreSmallOnes = 8;
  for (int l = 0; l < kMostMoments && moments.size() < wanted + kMoreSmallOnes; ++l) {
    moments.push_back(mixed_moment(scatterers, layer, scattering, l));
    if ((2.0 * l + 1.0) * std::abs(moments.back()) > kLeastTerm) wanted = moments.size();
  }
  moments.resize(wanted);
  for (double& moment : moments) moment = std::round(moment * 1e12) / 1e12;
  moments.front() = 1.0;
  return moments;
}

// Vertical extinction depth by layer of all aerosols.
std::vector<double> aerosol_depths(const Atmosphere& air, const OpticalCaseRequest& request) {
  std::vector<double> sum(air.shells().levels_km.size() - 1, 0.0);
  for (const ConstituentExtinction& constituent :
       air.extinctions({request.wavelength_nm, request.band_nm}, request.aod500))
    if (constituent.name.find("aerosol") != std::string::npos)
      for (std::size_t layer = 0; layer < sum.size(); ++layer)
        sum[layer] += constituent.terms.front().depth[layer];
  return sum;
}

Json layers_json(const OpticalColumn& column, const std::vector<double>& aerosol_depth) {
  const std::vector<double>& rayleigh_depth = column.scatterers.front().scattering_depth;
  const std::span aerosols = std::span(column.scatterers).subspan(1);
  Json layers = Json::array();
  for (std::size_t layer = 0; layer < aerosol_depth.size(); ++layer) {
    double scattering = 0.0;
    for (const Scatterer& aerosol : aerosols) scattering += aerosol.scattering_depth[layer];
    const double aerosol = aerosol_depth[layer];
    // Rounding may leave a difference below 0 where nothing absorbs.
    const double absorption = std::max(0.0, column.extinction_depth[layer] - rayleigh_depth[layer] - aerosol);
    Json written{{"tau_rayleigh", rayleigh_depth[layer]},
                 {"tau_aerosol", aerosol},
                 {"ssa_aerosol", aerosol > 0.0 ? std::min(1.0, scattering / aerosol) : 1.0},
                 {"g_aerosol", scattering > 0.0 ? mixed_moment(aerosols, layer, scattering, 1) : 0.0},
                 {"tau_absorption", absorption}};
    if (scattering > 0.0) written["phase_moments_aerosol"] = mixed_moments(aerosols, layer, scattering);
    layers.push_back(std::move(written));
  }
  return layers;
}

}  // namespace

Json optical_case(const Atmosphere& air, const OpticalCaseRequest& request) {
  const BandColumn term = chosen_term(air, request);
  Json results = Json::array();
  for (const RelativeView& view : request.views)
    results.push_back(
        {{"view_zenith_deg", view.zenith_deg}, {"relative_azimuth_deg", view.relative_azimuth_deg}});
  return {{"id", fmt::format("{}_{:g}nm_sza{:g}_alt{:g}", air.profile().name, request.wavelength_nm,
                             request.sun_zenith_deg, request.altitude_km)},
          {"geometry", "spherical"},
          {"wavelength_nm", request.wavelength_nm},
          {"absorption_term_weight", term.weight},
          {"planet_radius_km", air.shells().planet_radius_km},
          {"levels_km", air.shells().levels_km},
          {"rayleigh_depolarisation", air.depolarisation(request.wavelength_nm)},
          {"layers", layers_json(term.column, aerosol_depths(air, request))},
          {"albedo", term.column.ground_albedo},
          {"sun_zenith_deg", request.sun_zenith_deg},
          {"observer_altitude_km", request.altitude_km},
          {"results", results}};
}

}  // namespace skylut
