#include "skylut/transfer/plane_parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "plane_parallel/adding.hpp"
#include "plane_parallel/azimuth_series.hpp"
#include "plane_parallel/forward_peak_correction.hpp"
#include "plane_parallel/layer_modes.hpp"
#include "plane_parallel/scaled_medium.hpp"
#include "plane_parallel/single_scattering.hpp"
#include "plane_parallel/source_integration.hpp"
#include "plane_parallel/view_list.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/transfer_cost.hpp"

namespace skylut {
namespace {

using namespace plane_parallel;

/// Streams at most: beyond, delta-M and its corrections take over. An overhead sun needs one mode only; many
/// layers cost many eigenproblems.
constexpr int kMostStreams = 128;
constexpr int kMostStreamsManyLayers = 96;
constexpr int kMostStreamsOneMode = 400;
constexpr std::size_t kManyLayers = 12;
/// Q and U of coarse particles, which delta-M corrects less well, in a layer or two: half a minute.
constexpr int kMostStreamsPolarised = 240;
constexpr std::size_t kFewLayers = 2;

int most_streams(const OpticalColumn& column, bool one_mode, bool polarised) {
  if (one_mode) return kMostStreamsOneMode;
  if (polarised && column.extinction_depth.size() <= kFewLayers) return kMostStreamsPolarised;
  return column.extinction_depth.size() > kManyLayers ? kMostStreamsManyLayers : kMostStreams;
}

bool is_overhead(double cosine) { return std::abs(cosine) > 1.0 - 1e-12; }

void check(const OpticalColumn& column, const PlaneParallelRequest& request) {
  if (!(request.cos_sun_zenith > 0.0 && request.cos_sun_zenith <= 1.0))
    throw InputError("cosine of the sun zenith angle {}: must lie within 0 (excluded) to 1",
                     request.cos_sun_zenith);
  if (!(request.isotropic_top_radiance >= 0.0 && std::isfinite(request.isotropic_top_radiance)))
    throw InputError("uniform radiance from above {}: must be >= 0", request.isotropic_top_radiance);
  for (const PlaneDirection& direction : request.directions) {
    if (!(std::abs(direction.cos_view) <= 1.0) || direction.cos_view == 0.0)
      throw InputError(
          "cosine of a direction {}: must lie within -1 to 1 and not be 0 (a horizontal ray never leaves "
          "a plane layer)",
          direction.cos_view);
    if (!std::isfinite(direction.relative_azimuth_rad))
      throw InputError("relative azimuth {}: must be finite", direction.relative_azimuth_rad);
  }
  if (request.streams != 0 && (request.streams < 4 || request.streams > 512 || request.streams % 2 != 0))
    throw InputError("streams {}: must be even and within 4-512, or 0 for automatic", request.streams);
  if (!(column.ground_albedo >= 0.0 && column.ground_albedo <= 1.0))
    throw InputError("ground albedo {}: must lie within 0-1", column.ground_albedo);
  const std::size_t layers = column.extinction_depth.size();
  for (double depth : column.extinction_depth)
    if (!(depth >= 0.0 && std::isfinite(depth)))
      throw InputError("layer optical depth {}: must be >= 0", depth);
  for (const Scatterer& scatterer : column.scatterers) {
    if (scatterer.scattering_depth.size() != layers)
      throw InputError("scatterer with {} layers: must have {} as the column",
                       scatterer.scattering_depth.size(), layers);
    for (double depth : scatterer.scattering_depth)
      if (!(depth >= 0.0 && std::isfinite(depth)))
        throw InputError("layer scattering depth {}: must be >= 0", depth);
  }
  for (std::size_t layer = 0; layer < layers; ++layer) {
    double scattering = 0.0;
    for (const Scatterer& scatterer : column.scatterers) scattering += scatterer.scattering_depth[layer];
    // 1e-9: sums of parts given with 9 digits.
    if (scattering > column.extinction_depth[layer] * (1.0 + 1e-9))
      throw InputError("layer {} from the ground scatters {}: must not exceed its extinction {}", layer,
                       scattering, column.extinction_depth[layer]);
  }
}

/// Irradiances from mode 0. The scaled beam contains the forward peak; the true one does not: their
/// difference is diffuse light.
void set_fluxes(const ScaledMedium& medium, const Ordinates& ordinates, const BoundaryFields& fields,
                double cos_sun, PlaneParallelResult& result) {
  for (std::size_t bound : medium.output_bounds) {
    const double direct = cos_sun * std::exp(-medium.boundary_depth[bound] / cos_sun);
    const double scaled_direct = cos_sun * std::exp(-medium.boundary_scaled[bound] / cos_sun);
    result.flux_direct.push_back(direct);
    result.flux_down_diffuse.push_back(2.0 * kPi * ordinates.flux_root.dot(fields.down[bound]) +
                                       scaled_direct - direct);
    result.flux_up.push_back(2.0 * kPi * ordinates.flux_root.dot(fields.up[bound]));
  }
}

/// Zenith angles solved at a time: their rows in the matrices of every material take no more than this.
constexpr double kViewMemory_bytes = 256e6;

/// Stokes parameters that are solved.
double components(const PlaneParallelRequest& request) { return request.polarised ? 3.0 : 1.0; }

std::size_t views_at_a_time(const ScaledMedium& medium, const PlaneParallelRequest& request) {
  const double row_bytes = components(request) * components(request) * sizeof(double) *
                           static_cast<double>(medium.streams) *
                           (static_cast<double>(medium.optics.size()) + 1.0);
  return static_cast<std::size_t>(std::max(16.0, kViewMemory_bytes / row_bytes));
}

/// @throws InputError  for layers and results that the machine cannot hold
void refuse_too_much(const ScaledMedium& medium, const PlaneParallelRequest& request) {
  const double nodes = 0.5 * medium.streams * components(request);
  const auto slices = static_cast<double>(medium.slices.size());
  const double results = components(request) * sizeof(double) *
                         static_cast<double>(request.output_depths.size() * request.directions.size());
  const double need =
      sizeof(double) * nodes * nodes * (4.0 * slices + 2.0 * static_cast<double>(medium.optics.size())) +
      kViewMemory_bytes + 4.0 * results;
  const double memory = 0.75 * machine_memory_bytes();
  if (need > memory)
    throw InputError(
        "{} layers with {} results in plane-parallel layers need about {:.3g} GB of memory, {:.3g} "
        "GB may be used",
        medium.slices.size(), request.output_depths.size() * request.directions.size(), need / 1e9,
        memory / 1e9);
}

/// Fourier modes that there can be. A vertical beam has mode 0 only; so have vertical views, but for their Q
/// and U, which turn with the plane they are counted from.
int most_modes(const PlaneParallelRequest& request) {
  if (is_overhead(request.cos_sun_zenith)) return 1;
  const bool vertical = std::all_of(request.directions.begin(), request.directions.end(),
                                    [](const PlaneDirection& at) { return is_overhead(at.cos_view); });
  if (vertical) return request.polarised ? 3 : 1;
  return std::numeric_limits<int>::max();
}

/// Adds the light scattered more than once towards the directions of a request that has few zenith angles.
void add_multiple_scattering(const OpticalColumn& column, const ScaledMedium& medium,
                             const PlaneParallelRequest& request, PlaneParallelResult& result) {
  const double cos_sun = request.cos_sun_zenith;
  const Illumination light{cos_sun, request.isotropic_top_radiance, column.ground_albedo};
  const ViewList views(request.directions);
  const Eigen::VectorXd cos_views = Eigen::Map<const Eigen::VectorXd>(
      views.cosines.data(), static_cast<Eigen::Index>(views.cosines.size()));
  const Eigen::VectorXd cos_components = cos_views.replicate(request.polarised ? 3 : 1, 1);
  set_exact_single_scattering(column, medium, request, views, result);
  AzimuthSeries series(request, views, result);
  const int modes_at_most = std::min(most_modes(request), result.streams);
  bool converged = false;
  for (int mode = 0; mode < modes_at_most && !converged; ++mode) {
    const Ordinates ordinates = make_ordinates(result.streams, mode, cos_sun, cos_views, request.polarised);
    std::vector<LayerModes> modes;
    for (const LayerOptics& optics : medium.optics)
      modes.push_back(solve_layer_modes(optics, ordinates, cos_sun));
    const BoundaryFields fields = join_slices(medium, modes, ordinates, light);
    if (mode == 0) set_fluxes(medium, ordinates, fields, cos_sun, result);
    const Eigen::MatrixXd at_bounds =
        radiance_at_views(medium, modes, ordinates, light, fields, cos_components);
    converged = series.add(mode, at_bounds, medium.output_bounds);
    result.azimuth_modes = mode + 1;
  }
  correct_forward_peak(column, medium, request, result.radiance);
}

/// The directions in parts of so many zenith angles. @return of each part, indices into the directions
std::vector<std::vector<std::size_t>> parts_of(const std::vector<PlaneDirection>& directions,
                                               std::size_t views_each) {
  const ViewList views(directions);
  std::vector<std::vector<std::size_t>> parts(
      std::max<std::size_t>(1, (views.cosines.size() + views_each - 1) / views_each));
  for (std::size_t i = 0; i < directions.size(); ++i) parts[views.of_direction[i] / views_each].push_back(i);
  return parts;
}

PlaneParallelResult solve(const OpticalColumn& column, const PlaneParallelRequest& request) {
  PlaneParallelResult result;
  const bool one_mode = most_modes(request) == 1;
  result.streams = request.streams != 0
                       ? request.streams
                       : streams_for(column, most_streams(column, one_mode, request.polarised));
  const ScaledMedium medium = scale_medium(column, request.output_depths, result.streams, request.polarised);
  refuse_too_much(medium, request);
  const auto parts = parts_of(request.directions, views_at_a_time(medium, request));
  if (parts.size() == 1) {
    add_multiple_scattering(column, medium, request, result);
    return result;
  }
  result.radiance.resize(request.output_depths.size() * request.directions.size());
  if (request.polarised) result.stokes_q = result.stokes_u = result.radiance;
  for (const std::vector<std::size_t>& part : parts) {
    PlaneParallelRequest asked = request;
    asked.directions.clear();
    for (const std::size_t i : part) asked.directions.push_back(request.directions[i]);
    PlaneParallelResult found;
    found.streams = result.streams;
    add_multiple_scattering(column, medium, asked, found);
    for (std::size_t depth = 0; depth < request.output_depths.size(); ++depth)
      for (std::size_t i = 0; i < part.size(); ++i) {
        const std::size_t from = depth * part.size() + i;
        const std::size_t to = depth * request.directions.size() + part[i];
        result.radiance[to] = found.radiance[from];
        if (!request.polarised) continue;
        result.stokes_q[to] = found.stokes_q[from];
        result.stokes_u[to] = found.stokes_u[from];
      }
    result.flux_direct = found.flux_direct;
    result.flux_down_diffuse = found.flux_down_diffuse;
    result.flux_up = found.flux_up;
    result.azimuth_modes = std::max(result.azimuth_modes, found.azimuth_modes);
  }
  return result;
}

}  // namespace

std::vector<PlaneDirection> PlaneParallelRequest::every(const std::vector<double>& cos_views,
                                                        const std::vector<double>& relative_azimuths_rad) {
  std::vector<PlaneDirection> directions;
  for (const double cos_view : cos_views)
    for (const double azimuth : relative_azimuths_rad) directions.push_back({cos_view, azimuth});
  return directions;
}

PlaneParallelResult solve_plane_parallel(const OpticalColumn& column, const PlaneParallelRequest& request) {
  check(column, request);
  try {
    return solve(column, request);
  } catch (const std::bad_alloc&) {
    throw WorkError("plane-parallel transfer ran out of memory with {} layers and {} directions",
                    column.extinction_depth.size(), request.directions.size());
  }
}

}  // namespace skylut
