#include "skylut/transfer/direct_beam.hpp"

#include <cmath>

#include "geometry/shell_geometry.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "spherical/request_check.hpp"

namespace skylut {

std::optional<std::vector<double>> beam_path_factors(const Shells& shells, double altitude_km,
                                                     double sun_zenith_deg) {
  transfer::check_shells(shells);
  if (!(altitude_km >= 0.0 && altitude_km <= shells.levels_km.back()))
    throw InputError("observer altitude {} km: must lie within the layers, 0-{} km", altitude_km,
                     shells.levels_km.back());
  if (!(sun_zenith_deg >= 0.0 && sun_zenith_deg <= 180.0))
    throw InputError("sun zenith {} deg: must lie within 0-180", sun_zenith_deg);
  const transfer::ShellGeometry geometry(shells.levels_km, shells.planet_radius_km);
  std::vector<double> factors;
  if (!geometry.path_to_top(altitude_km, std::cos(sun_zenith_deg * kRadiansPerDegree), factors))
    return std::nullopt;
  for (std::size_t layer = 0; layer < factors.size(); ++layer)
    factors[layer] /= shells.levels_km[layer + 1] - shells.levels_km[layer];
  return factors;
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
