#include "request_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "angular_grid.hpp"
#include "skylut/core/domain.hpp"

namespace skylut::transfer {

namespace {

/// Delta-M asks for moments up to here; beyond they only have to be there.
constexpr int kCheckedMoments = (4 * (kMostLegendreDegree + 1) + 2) / 3;

/// Inside the air or outside.
constexpr Range kAnyObserver_km{0.0, 1e6, "km"};

/// No light gets through a hundredth of it, and single precision still holds the slant depths.
constexpr double kMostLayerDepth = 1e6;

void check_phase_function(const Scatterer& scatterer) {
  if (!scatterer.phase) throw InputError("scatterer: must have a phase function");
  for (int l = 0; l <= kCheckedMoments; ++l)
    if (const double moment = scatterer.phase->moment(l); !(std::abs(moment) <= 1.0 + 1e-6))
      throw InputError("Legendre moment {} of a phase function, {}: must lie within -1 to 1", l, moment);
}

/// Of the degrees that the default quality carries of a narrow peak, the first beyond.
constexpr int kPeakDegree = 21;

/// The largest share of a layer's scattering, among those that matter, that lies in forward peaks which those
/// degrees cannot carry.
double forward_share(const OpticalColumn& column) {
  double total = 0.0;
  std::vector<double> peak;
  for (const Scatterer& scatterer : column.scatterers) {
    peak.push_back(scatterer.phase->moment(kPeakDegree));
    for (const double depth : scatterer.scattering_depth) total += depth;
  }
  double largest = 0.0;
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    double scattering = 0.0;
    double forward = 0.0;
    for (std::size_t s = 0; s < peak.size(); ++s) {
      scattering += column.scatterers[s].scattering_depth[layer];
      forward += column.scatterers[s].scattering_depth[layer] * peak[s];
    }
    if (scattering > 1e-3 * total) largest = std::max(largest, forward / scattering);
  }
  return largest;
}

/// Delta-M takes forward peaks for unscattered light, which at the horizon, where the sky meets the ground,
/// is put right for a peak of some per cent (L6) but not for one that holds most of the scattering: g = 0.95
/// is 4 % too bright at 89.9 degrees, 0.99 26 %; 5 degrees from the horizon 1-2 %.
void check_grazing_sights(std::span<const OpticalColumn> columns, std::span<const Sight> sights) {
  constexpr double kMostForward = 0.25;
  constexpr double kGrazing_deg = 5.0;
  const auto grazing = std::find_if(sights.begin(), sights.end(), [](const Sight& sight) {
    return std::abs(sight.view.zenith_deg - 90.0) < kGrazing_deg;
  });
  if (grazing == sights.end()) return;
  for (const OpticalColumn& column : columns)
    if (const double share = forward_share(column); share > kMostForward)
      throw InputError(
          "view zenith {} deg: a forward peak of {:.0f} % of the scattering is right only for views 5 deg or "
          "more "
          "from the horizon; the Monte Carlo (solve --method monte-carlo) does the others",
          grazing->view.zenith_deg, 100.0 * share);
}

}  // namespace

void check_column(const OpticalColumn& column, std::size_t layers) {
  if (column.extinction_depth.size() != layers)
    throw InputError("optical column with {} layers: the levels give {}", column.extinction_depth.size(),
                     layers);
  if (!(column.ground_albedo >= 0.0 && column.ground_albedo <= 1.0))
    throw InputError("ground albedo {}: must lie within 0-1", column.ground_albedo);
  for (const Scatterer& scatterer : column.scatterers) {
    check_phase_function(scatterer);
    if (scatterer.scattering_depth.size() != layers)
      throw InputError("scatterer with {} layers: the levels give {}", scatterer.scattering_depth.size(),
                       layers);
  }
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
    if (extinction > kMostLayerDepth)
      throw InputError("optical depth {:.4g} in layer {}: must be at most {:g}, which is as opaque",
                       extinction, layer, kMostLayerDepth);
  }
}

void check_shells(const Shells& shells) {
  const std::vector<double>& levels = shells.levels_km;
  if (levels.size() < 2 || levels.front() != 0.0)
    throw InputError("levels_km: needs at least two levels, the first at 0");
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (!(levels[i] > levels[i - 1]) || !std::isfinite(levels[i]))
      throw InputError("levels_km: {} after {}, must ascend", levels[i], levels[i - 1]);
  require_within("levels_km", levels.back(), domain::kLevel_km);
  require_within("planet_radius_km", shells.planet_radius_km, domain::kPlanetRadius_km);
}

void check_place(const Shells& shells, double altitude_km, double sun_zenith_deg) {
  check_shells(shells);
  if (!(altitude_km >= 0.0 && altitude_km <= shells.levels_km.back()))
    throw InputError("observer altitude {} km: must lie within the layers, 0-{} km", altitude_km,
                     shells.levels_km.back());
  if (!(sun_zenith_deg >= 0.0 && sun_zenith_deg <= 180.0))
    throw InputError("sun zenith {} deg: must lie within 0-180", sun_zenith_deg);
}

void check_sight(const Sight& sight, double top_km) {
  require_within("observer altitude", sight.observer_altitude_km, kAnyObserver_km);
  // The sun of an observer outside says little of the sun over the air that he sees.
  const bool outside = sight.observer_altitude_km > top_km;
  require_within("sun zenith", sight.sun_zenith_deg,
                 outside ? domain::kAnyZenith_deg : domain::kSunZenith_deg);
  const RelativeView& view = sight.view;
  if (!(view.zenith_deg >= 0.0 && view.zenith_deg <= 180.0 && view.relative_azimuth_deg >= 0.0 &&
        view.relative_azimuth_deg <= 180.0))
    throw InputError("view zenith {} deg, relative azimuth {} deg: must lie within 0-180", view.zenith_deg,
                     view.relative_azimuth_deg);
}

void check_request(const Shells& shells, std::span<const OpticalColumn> columns,
                   std::span<const Sight> sights, const TransferOptions& options) {
  check_shells(shells);
  for (const OpticalColumn& column : columns) check_column(column, shells.levels_km.size() - 1);
  check_discretisation(options.discretisation);
  if (options.scattering_orders < 0)
    throw InputError("orders {}: must be >= 0 (0: all)", options.scattering_orders);
  if (!(options.most_memory_bytes >= 0.0))
    throw InputError("memory limit {} bytes: must be >= 0 (0: by the machine)", options.most_memory_bytes);
  if (options.stokes && options.discretisation.polarised_degree == 0)
    throw InputError("Q and U are asked for, but polarised-degrees is 0: must be 2 to 30");
  for (const Sight& sight : sights) check_sight(sight, shells.levels_km.back());
  // Order by order nothing is cut off.
  if (options.scattering_orders == 0) check_grazing_sights(columns, sights);
}

}  // namespace skylut::transfer
