#include "skylut/transfer/direct_beam.hpp"

#include <cmath>

#include "geometry/shell_geometry.hpp"
#include "geometry/sun_refraction.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "spherical/request_check.hpp"

namespace skylut {

namespace {

/// @param stretch  length over that among the shells, by layer; empty: 1
std::optional<std::vector<double>> factors_towards(const transfer::ShellGeometry& geometry,
                                                   double altitude_km, double cos_zenith,
                                                   const std::vector<double>& stretch,
                                                   const std::vector<double>& levels_km) {
  std::vector<double> factors;
  if (!geometry.path_to_top(altitude_km, cos_zenith, factors)) return std::nullopt;
  for (std::size_t layer = 0; layer < factors.size(); ++layer) {
    if (!stretch.empty()) factors[layer] *= stretch[layer];
    factors[layer] /= levels_km[layer + 1] - levels_km[layer];
  }
  return factors;
}

}  // namespace

std::optional<std::vector<double>> sight_path_factors(const Shells& shells, double altitude_km,
                                                      double view_zenith_deg) {
  transfer::check_place(shells, altitude_km, view_zenith_deg);
  const double cosine = std::cos(view_zenith_deg * kRadiansPerDegree);
  if (shells.refractivity.empty()) {
    const transfer::ShellGeometry geometry(shells.levels_km, shells.planet_radius_km);
    return factors_towards(geometry, altitude_km, cosine, {}, shells.levels_km);
  }
  const transfer::RefractiveShells air(shells);
  return factors_towards(air.optical(), air.optical_km(altitude_km), cosine, air.stretch(), shells.levels_km);
}

std::optional<std::vector<double>> beam_path_factors(const Shells& shells, double altitude_km,
                                                     double sun_zenith_deg) {
  if (shells.refractivity.empty()) return sight_path_factors(shells, altitude_km, sun_zenith_deg);
  transfer::check_place(shells, altitude_km, sun_zenith_deg);
  const transfer::RefractiveShells air(shells);
  const transfer::SunRefraction refraction(air, transfer::SunRefraction::Bending::integrated);
  const double sun = sun_zenith_deg * kRadiansPerDegree;
  if (sun > refraction.last_sun_rad(altitude_km)) return std::nullopt;
  const transfer::Sunbeam beam = refraction.sunbeam(altitude_km, std::cos(sun));
  // A beam that grazes the ground misses it, to the last bit of its cosine.
  constexpr double kGrazing = 1e-12;
  const double cosine = beam.along_sun_km / (air.optical().planet_radius_km() + beam.altitude_km);
  return factors_towards(air.optical(), beam.altitude_km, cosine + (cosine < 0.0 ? kGrazing : 0.0),
                         air.stretch(), shells.levels_km);
}

double beam_transmittance(const std::vector<double>& path_factors, const std::vector<double>& depth) {
  if (path_factors.size() != depth.size())
    throw InputError("beam through {} layers: {} optical depths, must be as many", path_factors.size(),
                     depth.size());
  double sum = 0.0;
  for (std::size_t layer = 0; layer < depth.size(); ++layer) sum += depth[layer] * path_factors[layer];
  return std::exp(-sum);
}

}  // namespace skylut
