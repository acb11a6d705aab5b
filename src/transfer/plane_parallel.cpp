#include "skylut/transfer/plane_parallel.hpp"

#include <algorithm>
#include <cmath>

#include "plane_parallel/adding.hpp"
#include "plane_parallel/aureole_correction.hpp"
#include "plane_parallel/layer_modes.hpp"
#include "plane_parallel/scaled_medium.hpp"
#include "plane_parallel/single_scattering.hpp"
#include "plane_parallel/source_integration.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

using namespace plane_parallel;

/// The Fourier series ends when two modes in a row change no radiance by more than this share of it.
constexpr double kAzimuthConvergence = 1e-6;

/// Streams at most: beyond, delta-M and its corrections take over. An overhead sun needs one mode only; many
/// layers cost many eigenproblems.
constexpr int kMostStreams = 128;
constexpr int kMostStreamsManyLayers = 96;
constexpr int kMostStreamsOneMode = 400;
constexpr std::size_t kManyLayers = 12;

int most_streams(const OpticalColumn& column, bool one_mode) {
  if (one_mode) return kMostStreamsOneMode;
  return column.extinction_depth.size() > kManyLayers ? kMostStreamsManyLayers : kMostStreams;
}

bool is_overhead(double cosine) { return std::abs(cosine) > 1.0 - 1e-12; }

void check(const OpticalColumn& column, const PlaneParallelRequest& request) {
  if (!(request.cos_sun_zenith > 0.0 && request.cos_sun_zenith <= 1.0))
    throw InputError("cosine of the sun zenith angle {}: must lie within 0 (excluded) to 1",
                     request.cos_sun_zenith);
  if (!(request.isotropic_top_radiance >= 0.0 && std::isfinite(request.isotropic_top_radiance)))
    throw InputError("uniform radiance from above {}: must be >= 0", request.isotropic_top_radiance);
  for (double cosine : request.cos_views)
    if (!(std::abs(cosine) <= 1.0) || cosine == 0.0)
      throw InputError(
          "cosine of a direction {}: must lie within -1 to 1 and not be 0 (a horizontal ray never leaves "
          "a plane layer)",
          cosine);
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

/// Sums the azimuth series into the result.
class AzimuthSeries {
 public:
  AzimuthSeries(const PlaneParallelRequest& request, std::vector<double>& radiance)
      : request_(request), radiance_(radiance) {}

  /// Adds mode m. @return true once the series has converged
  bool add(int mode, const Eigen::MatrixXd& at_bounds, const std::vector<std::size_t>& output_bounds) {
    double largest = 0.0;
    for (double value : radiance_) largest = std::max(largest, std::abs(value));
    double change = 0.0;
    std::size_t at = 0;
    for (std::size_t bound : output_bounds)
      for (std::size_t view = 0; view < request_.cos_views.size(); ++view) {
        const double part = at_bounds(static_cast<Eigen::Index>(bound), static_cast<Eigen::Index>(view));
        for (double azimuth : request_.relative_azimuths_rad) {
          radiance_[at] += part * std::cos(mode * azimuth);
          // Radiances 1e-10 of the largest carry no information.
          change = std::max(change, std::abs(part) / (std::abs(radiance_[at]) + 1e-10 * largest));
          ++at;
        }
      }
    small_in_a_row_ = change < kAzimuthConvergence ? small_in_a_row_ + 1 : 0;
    return small_in_a_row_ >= 2;
  }

 private:
  const PlaneParallelRequest& request_;
  std::vector<double>& radiance_;
  int small_in_a_row_ = 0;
};

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

}  // namespace

PlaneParallelResult solve_plane_parallel(const OpticalColumn& column, const PlaneParallelRequest& request) {
  check(column, request);
  const double cos_sun = request.cos_sun_zenith;
  // A vertical beam or vertical views have no azimuth: mode 0 is all.
  const bool symmetric =
      is_overhead(cos_sun) || std::all_of(request.cos_views.begin(), request.cos_views.end(), is_overhead);
  PlaneParallelResult result;
  result.streams =
      request.streams != 0 ? request.streams : streams_for(column, most_streams(column, symmetric));
  const ScaledMedium medium = scale_medium(column, request.output_depths, result.streams);
  const Illumination light{cos_sun, request.isotropic_top_radiance, column.ground_albedo};
  const Eigen::VectorXd cos_views = Eigen::Map<const Eigen::VectorXd>(
      request.cos_views.data(), static_cast<Eigen::Index>(request.cos_views.size()));

  result.radiance = exact_single_scattering(column, medium, request);
  AzimuthSeries series(request, result.radiance);
  const int most_modes = symmetric ? 1 : result.streams;
  bool converged = false;
  for (int mode = 0; mode < most_modes && !converged; ++mode) {
    const Ordinates ordinates = make_ordinates(result.streams, mode, cos_sun, cos_views);
    std::vector<LayerModes> modes;
    for (const LayerOptics& optics : medium.optics)
      modes.push_back(solve_layer_modes(optics, ordinates, cos_sun));
    const BoundaryFields fields = join_slices(medium, modes, ordinates, light);
    if (mode == 0) set_fluxes(medium, ordinates, fields, cos_sun, result);
    const Eigen::MatrixXd at_bounds = radiance_at_views(medium, modes, ordinates, light, fields, cos_views);
    converged = series.add(mode, at_bounds, medium.output_bounds);
    result.azimuth_modes = mode + 1;
  }
  correct_aureole(column, medium, request, result.radiance);
  return result;
}

}  // namespace skylut
