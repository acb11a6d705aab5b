#include "skylut/cases/solve_case.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "case_layers.hpp"
#include "case_matrices.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/domain.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/json_reader.hpp"
#include "skylut/core/version.hpp"
#include "skylut/transfer/monte_carlo.hpp"
#include "skylut/transfer/plane_parallel.hpp"

namespace skylut {
namespace {

using Json = nlohmann::ordered_json;

void refuse_what_plane_parallel_cannot(const JsonReader& file, const SolveOptions& options) {
  if (options.method == SolveMethod::monte_carlo)
    throw WorkError("{}: the Monte Carlo solver does not do plane-parallel layers: use --method default",
                    file.name());
  if (options.orders != 0)
    throw WorkError("{}: the plane-parallel solver sums all orders of scattering: leave out --orders {}",
                    file.name(), options.orders);
}

OpticalColumn read_column(const JsonReader& file) {
  const double depolarisation =
      file.has("rayleigh_depolarisation")
          ? file.at("rayleigh_depolarisation").number(0.0, 0.5, "within 0-0.5 (a depolarisation ratio)")
          : 0.0;
  return read_layers(file.at("layers").elements(), depolarisation);
}

/// Whether Stokes Q and U are asked for.
bool read_polarised(const JsonReader& file) {
  if (!file.has("polarised")) return false;
  const JsonReader polarised = file.at("polarised");
  if (!polarised.value().is_boolean())
    polarised.refuse(fmt::format("{} must be true or false", polarised.value().dump()));
  return polarised.value().get<bool>();
}

double read_albedo(const JsonReader& file) { return file.at("albedo").number(0.0, 1.0, "within 0-1"); }

// ---- schema of problems in optical depth: keys beam, outputs, layers top to bottom

Json solve_depth_schema(const JsonReader& file, const SolveOptions& options) {
  if (const std::string geometry = file.at("geometry").text(); geometry != "plane-parallel")
    file.at("geometry")
        .refuse(fmt::format("\"{}\" must be \"plane-parallel\" in a case with outputs at optical depths",
                            geometry));
  refuse_what_plane_parallel_cannot(file, options);
  if (const std::string order = file.at("layer_order").text(); order != "top to bottom")
    file.at("layer_order").refuse(fmt::format("\"{}\" must be \"top to bottom\"", order));
  OpticalColumn column = read_column(file);
  reverse_layers(column);
  column.ground_albedo = read_albedo(file);

  const JsonReader beam = file.at("beam");
  const double flux = beam.at("flux").number(0.0, 1e300, "> 0");
  if (flux == 0.0) beam.at("flux").refuse("0 must be a number > 0");
  const double phi0_deg = beam.at("phi0_deg").number();
  const JsonReader outputs = file.at("outputs");
  PlaneParallelRequest request;
  request.polarised = read_polarised(file);
  request.cos_sun_zenith = beam.at("mu0").number(0.0, 1.0, "within 0 (excluded) to 1");
  if (request.cos_sun_zenith == 0.0) beam.at("mu0").refuse("0 must be a number within 0 (excluded) to 1");
  request.isotropic_top_radiance = file.at("isotropic_top").number(0.0, 1e300, ">= 0") / flux;
  request.output_depths = outputs.at("taus").numbers(0.0, 1e300, ">= 0");
  const std::vector<double> cos_views = outputs.at("umu").numbers(-1.0, 1.0, "within -1 to 1 and not 0");
  for (const JsonReader& umu : outputs.at("umu").elements())
    if (umu.number() == 0.0) umu.refuse("0 must be a number within -1 to 1 and not 0");
  std::vector<double> azimuths_rad;
  for (const JsonReader& phi : outputs.at("phi_deg").elements())
    azimuths_rad.push_back((phi.number() - phi0_deg) * kRadiansPerDegree);
  request.directions = PlaneParallelRequest::every(cos_views, azimuths_rad);
  double total = 0.0;
  for (double depth : column.extinction_depth) total += depth;
  for (const JsonReader& tau : outputs.at("taus").elements())
    // Depths are given with about 12 digits.
    if (tau.number() > total * (1.0 + 1e-9))
      tau.refuse(fmt::format("{} must lie within the column, 0-{}", tau.number(), total));
  for (double& depth : request.output_depths) depth = std::min(depth, total);

  const PlaneParallelResult result = solve_plane_parallel(column, request);
  Json answer = file.value();
  Json& written = answer["outputs"];
  const auto by_depth = [&](const std::vector<double>& values) {
    Json all = Json::array();
    std::size_t at = 0;
    for (std::size_t depth = 0; depth < request.output_depths.size(); ++depth) {
      Json at_depth = Json::array();
      for (std::size_t view = 0; view < cos_views.size(); ++view) {
        Json at_view = Json::array();
        for (std::size_t phi = 0; phi < azimuths_rad.size(); ++phi) at_view.push_back(flux * values[at++]);
        at_depth.push_back(std::move(at_view));
      }
      all.push_back(std::move(at_depth));
    }
    return all;
  };
  const auto scaled = [flux](std::vector<double> values) {
    for (double& value : values) value *= flux;
    return values;
  };
  written["radiance"] = by_depth(result.radiance);
  if (request.polarised) {
    written["stokes_q"] = by_depth(result.stokes_q);
    written["stokes_u"] = by_depth(result.stokes_u);
  }
  written["flux_direct"] = scaled(result.flux_direct);
  written["flux_down_diffuse"] = scaled(result.flux_down_diffuse);
  written["flux_up"] = scaled(result.flux_up);
  answer["streams_used"] = result.streams;
  answer.erase("convergence");
  return answer;
}

// ---- schema of skies in altitude: keys levels_km, observer_altitude_km, results, layers bottom to top

struct AltitudeCase {
  Shells shells;
  OpticalColumn column;
  double observer_km = 0.0;
  double sun_zenith_deg = 0.0;
  std::vector<RelativeView> views;
  bool polarised = false;
  /// 1, or -1 where the file's azimuth lies in the half that mirrors the view's: the sign of U.
  std::vector<double> side;
};

AltitudeCase read_altitude_schema(const JsonReader& file) {
  AltitudeCase read;
  const JsonReader levels = file.at("levels_km");
  read.shells.levels_km = levels.numbers(
      0.0, domain::kLevel_km.highest, fmt::format("within 0-{} km (an altitude)", domain::kLevel_km.highest));
  if (read.shells.levels_km.front() != 0.0) levels.refuse("the first level must be 0, the ground");
  for (std::size_t i = 1; i < read.shells.levels_km.size(); ++i)
    if (!(read.shells.levels_km[i] > read.shells.levels_km[i - 1]))
      levels.elements()[i].refuse(fmt::format("{} must lie above {}, the level before",
                                              read.shells.levels_km[i], read.shells.levels_km[i - 1]));
  const std::vector<JsonReader> layers = file.at("layers").elements();
  if (layers.size() + 1 != read.shells.levels_km.size())
    file.at("layers").refuse(fmt::format("{} layers must be one fewer than the {} levels_km", layers.size(),
                                         read.shells.levels_km.size()));
  read.column = read_column(file);
  read.column.ground_albedo = read_albedo(file);
  const double top = read.shells.levels_km.back();
  read.observer_km =
      file.at("observer_altitude_km").number(0.0, top, fmt::format("within the levels, 0-{}", top));
  read.sun_zenith_deg = file.at("sun_zenith_deg").number(0.0, 180.0, "within 0-180");
  read.polarised = read_polarised(file);
  for (const JsonReader& result : file.at("results").elements()) {
    const double azimuth_deg = std::remainder(result.at("relative_azimuth_deg").number(), 360.0);
    read.views.push_back(
        {result.at("view_zenith_deg").number(0.0, 180.0, "within 0-180"), std::abs(azimuth_deg)});
    read.side.push_back(azimuth_deg < 0.0 ? -1.0 : 1.0);
  }
  return read;
}

void write_radiance(Json& result, double radiance, double standard_error) {
  result["radiance"] = radiance;
  result["std"] = standard_error;
  result.erase("photons");
}

/// A Stokes parameter with its standard error, 0 for a deterministic solver.
struct Estimate {
  double value = 0.0;
  double standard_error = 0.0;
};

/// Q and U of a view of the case; U as the view has it, on the file's side of the sun here.
void write_polarisation(Json& result, Estimate q, Estimate u, double side) {
  result["stokes_q"] = q.value;
  result["std_q"] = q.standard_error;
  result["stokes_u"] = side * u.value;
  result["std_u"] = u.standard_error;
}

/// Optical depth above an altitude; layers are homogeneous between their levels.
double depth_above(const AltitudeCase& read, double altitude_km) {
  double depth = 0.0;
  for (std::size_t i = 0; i < read.column.extinction_depth.size(); ++i) {
    const double low = read.shells.levels_km[i];
    const double high = read.shells.levels_km[i + 1];
    if (altitude_km <= low)
      depth += read.column.extinction_depth[i];
    else if (altitude_km < high)
      depth += read.column.extinction_depth[i] * (high - altitude_km) / (high - low);
  }
  return depth;
}

Json solve_plane_layers(const JsonReader& file, const SolveOptions& options) {
  refuse_what_plane_parallel_cannot(file, options);
  const AltitudeCase read = read_altitude_schema(file);
  if (!(read.sun_zenith_deg < 90.0))
    file.at("sun_zenith_deg")
        .refuse(fmt::format("{} must be below 90 in plane-parallel layers", read.sun_zenith_deg));
  PlaneParallelRequest request;
  request.cos_sun_zenith = std::cos(read.sun_zenith_deg * kRadiansPerDegree);
  request.output_depths = {depth_above(read, read.observer_km)};
  request.polarised = read.polarised;
  Json answer = file.value();
  for (const RelativeView& view : read.views) {
    if (std::abs(view.zenith_deg - 90.0) < 1e-9)
      file.at("results").refuse("view_zenith_deg 90 must not be horizontal in plane-parallel layers");
    // The light travels against the direction in which the observer looks; azimuths agree, as the beam, too,
    // travels against the direction to the sun.
    request.directions.push_back(
        {-std::cos(view.zenith_deg * kRadiansPerDegree), view.relative_azimuth_deg * kRadiansPerDegree});
  }
  const PlaneParallelResult result = solve_plane_parallel(read.column, request);
  for (std::size_t i = 0; i < read.views.size(); ++i) {
    write_radiance(answer["results"][i], result.radiance[i], 0.0);
    if (read.polarised)
      write_polarisation(answer["results"][i], {result.stokes_q[i]}, {result.stokes_u[i]}, read.side[i]);
  }
  answer["fluxes"]["direct_down"] = result.flux_direct[0];
  answer["fluxes"]["diffuse_down"] = result.flux_down_diffuse[0];
  answer["fluxes"]["diffuse_up"] = result.flux_up[0];
  return answer;
}

/// Largest relative share of the radiance that the orders left out hold, over all directions.
double truncation_error(const Context& context, const AltitudeCase& read, const SkyRequest& request,
                        TransferOptions transfer, const SkyRadiance& truncated) {
  transfer.scattering_orders = 0;
  const SkyRadiance whole = solve_sky_radiance(context, read.shells, {&read.column, 1}, request, transfer);
  double largest = 0.0;
  for (std::size_t i = 0; i < request.views.size(); ++i)
    if (whole.at(0, 0, 0, i) > 0.0f)
      largest = std::max(largest, std::abs(1.0 - static_cast<double>(truncated.at(0, 0, 0, i)) /
                                                     static_cast<double>(whole.at(0, 0, 0, i))));
  return largest;
}

Json solve_shells(const Context& context, const JsonReader& file, const SolveOptions& options) {
  AltitudeCase read = read_altitude_schema(file);
  read.shells.planet_radius_km = file.at("planet_radius_km").number(domain::kPlanetRadius_km);
  if (read.sun_zenith_deg > domain::kSunZenith_deg.highest)
    file.at("sun_zenith_deg")
        .refuse(fmt::format("{} must lie within 0-{} in spherical shells", read.sun_zenith_deg,
                            domain::kSunZenith_deg.highest));
  Json answer = file.value();
  if (options.method == SolveMethod::monte_carlo) {
    const MonteCarloRequest request{read.observer_km, read.sun_zenith_deg, read.views};
    const std::vector<MonteCarloRadiance> radiance =
        solve_monte_carlo(context, read.shells, read.column, request,
                          {.photons = options.photons,
                           .seed = options.seed,
                           .orders = options.orders,
                           .polarised = read.polarised});
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      write_radiance(answer["results"][i], radiance[i].radiance, radiance[i].standard_error);
      answer["results"][i]["photons"] = radiance[i].photons;
      if (read.polarised)
        write_polarisation(answer["results"][i], {radiance[i].stokes_q, radiance[i].stokes_q_error},
                           {radiance[i].stokes_u, radiance[i].stokes_u_error}, read.side[i]);
    }
    return answer;
  }
  const SkyRequest request{{read.observer_km}, {read.sun_zenith_deg}, read.views};
  TransferOptions transfer;
  transfer.discretisation = options.discretisation;
  transfer.scattering_orders = options.orders;
  transfer.stokes = read.polarised;
  if (!read.polarised) transfer.discretisation.polarised_degree = 0;
  const SkyRadiance radiance = solve_sky_radiance(context, read.shells, {&read.column, 1}, request, transfer);
  for (std::size_t i = 0; i < read.views.size(); ++i) {
    write_radiance(answer["results"][i], static_cast<double>(radiance.at(0, 0, 0, i)), 0.0);
    if (read.polarised)
      write_polarisation(answer["results"][i], {static_cast<double>(radiance.stokes_q(0, i))},
                         {static_cast<double>(radiance.stokes_u(0, i))}, read.side[i]);
  }
  answer["instruction_set"] = radiance.report().kernel;
  if (options.orders > 0) {
    answer["orders"] = options.orders;
    answer["truncation_error"] = truncation_error(context, read, request, transfer, radiance);
  }
  return answer;
}

Json solve_altitude_schema(const Context& context, const JsonReader& file, const SolveOptions& options) {
  const JsonReader geometry = file.at("geometry");
  if (geometry.text() == "spherical") return solve_shells(context, file, options);
  if (geometry.text() == "plane-parallel") return solve_plane_layers(file, options);
  geometry.refuse(fmt::format("\"{}\" must be \"spherical\" or \"plane-parallel\"", geometry.text()));
}

}  // namespace

Json solve_case(const Context& context, const Json& document, const std::string& path,
                const SolveOptions& options) {
  const JsonReader file(document, path);
  if (!document.is_object()) file.refuse("must hold one JSON object, a solver case");
  if (file.has("outputs") == file.has("results"))
    file.refuse("must have one of the keys \"results\" (altitudes) and \"outputs\" (optical depths)");
  Json answer =
      file.has("outputs") ? solve_depth_schema(file, options) : solve_altitude_schema(context, file, options);
  if (const auto unused = unused_elements(file.at("layers").elements()); !unused.empty())
    answer["not_used"] = unused;
  answer["reference"] = fmt::format("skylut {}", kVersion);
  return answer;
}

}  // namespace skylut
