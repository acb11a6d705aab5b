#include "request_check.hpp"

#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut::transfer {

namespace {

constexpr double kLargestSunZenith_deg = 96.0;
constexpr std::size_t kMostLevels = 250;  // of depth_to_sun in line_of_sight.hpp
constexpr double kSmallestPlanet_km = 100.0;

void check_column(const OpticalColumn& column, std::size_t layers) {
  if (column.extinction_depth.size() != layers)
    throw InputError("optical column with {} layers: the levels give {}", column.extinction_depth.size(),
                     layers);
  if (!(column.ground_albedo >= 0.0 && column.ground_albedo <= 1.0))
    throw InputError("ground albedo {}: must lie within 0-1", column.ground_albedo);
  for (const Scatterer& scatterer : column.scatterers)
    if (scatterer.scattering_depth.size() != layers)
      throw InputError("scatterer with {} layers: the levels give {}", scatterer.scattering_depth.size(),
                       layers);
  for (std::size_t layer = 0; layer < layers; ++layer) {
    double scattering = 0.0;
    for (const Scatterer& scatterer : column.scatterers) {
      const double depth = scatterer.scattering_depth[layer];
      if (!(depth >= 0.0)) throw InputError("scattering depth {} in layer {}: must be >= 0", depth, layer);
      scattering += depth;
    }
    const double extinction = column.extinction_depth[layer];
    if (!(extinction >= scattering * (1.0 - 1e-9)) || !std::isfinite(extinction))
      throw InputError("extinction depth {} in layer {}: must be finite and at least the scattering's, {}",
                       extinction, layer, scattering);
  }
}

}  // namespace

void check_shells(const Shells& shells) {
  const std::vector<double>& levels = shells.levels_km;
  if (levels.size() < 2 || levels.front() != 0.0)
    throw InputError("levels_km: needs at least two levels, the first at 0");
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (!(levels[i] > levels[i - 1]) || !std::isfinite(levels[i]))
      throw InputError("levels_km: {} after {}, must ascend", levels[i], levels[i - 1]);
  if (levels.size() > kMostLevels)
    throw InputError("levels_km: {} levels, at most {}", levels.size(), kMostLevels);
  if (!(shells.planet_radius_km >= kSmallestPlanet_km && std::isfinite(shells.planet_radius_km)))
    throw InputError("planet_radius_km {}: must be finite and at least {}", shells.planet_radius_km,
                     kSmallestPlanet_km);
}

void check_request(const Shells& shells, std::span<const OpticalColumn> columns, const SkyRequest& request) {
  check_shells(shells);
  for (const OpticalColumn& column : columns) check_column(column, shells.levels_km.size() - 1);
  for (const double altitude : request.observer_altitudes_km)
    if (!(altitude >= 0.0 && altitude <= shells.levels_km.back()))
      throw InputError("observer altitude {} km: must lie within the layers, 0-{} km", altitude,
                       shells.levels_km.back());
  for (const double sun : request.sun_zeniths_deg)
    if (!(sun >= 0.0 && sun <= kLargestSunZenith_deg))
      throw InputError("sun zenith {} deg: must lie within 0-{}", sun, kLargestSunZenith_deg);
  for (const RelativeView& view : request.views)
    if (!(view.zenith_deg >= 0.0 && view.zenith_deg <= 180.0 && view.relative_azimuth_deg >= 0.0 &&
          view.relative_azimuth_deg <= 180.0))
      throw InputError("view zenith {} deg, relative azimuth {} deg: must lie within 0-180", view.zenith_deg,
                       view.relative_azimuth_deg);
}

}  // namespace skylut::transfer
