#include "scaled_medium.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut::plane_parallel {
namespace {

constexpr double kNegligibleMoment = 1e-4;
constexpr int kFewestStreams = 48;

/// Output depths nearer than this to a boundary, relative to the column, are taken to lie on it: depths
/// in case files are sums printed to 12 digits.
constexpr double kSameDepth = 1e-10;

/// Moments of the matrices of all scatterers, up to the number of streams.
using AllMatrixMoments = std::vector<std::vector<MatrixMoments>>;

void set_matrix(const AllMatrixMoments& matrices, double forward, LayerOptics& optics) {
  const Eigen::Index streams = optics.moments.size();
  optics.alpha2 = optics.alpha3 = optics.beta1 = Eigen::VectorXd::Zero(streams);
  double albedo = 0.0;
  for (double share : optics.scatterer_albedos) albedo += share;
  for (Eigen::Index l = 2; l < streams; ++l) {
    for (std::size_t s = 0; s < matrices.size(); ++s) {
      const double share = optics.scatterer_albedos[s] / albedo;
      if (share == 0.0) continue;
      const MatrixMoments& moments = matrices[s][static_cast<std::size_t>(l)];
      optics.alpha2[l] += share * moments.alpha2;
      optics.alpha3[l] += share * moments.alpha3;
      optics.beta1[l] += share * moments.beta1;
    }
    optics.alpha2[l] = (optics.alpha2[l] - forward) / (1.0 - forward);
    optics.alpha3[l] = (optics.alpha3[l] - forward) / (1.0 - forward);
    optics.beta1[l] /= 1.0 - forward;
  }
}

/// @param matrices  empty: without polarisation
LayerOptics layer_optics(const OpticalColumn& column, const AllMatrixMoments& matrices, std::size_t layer,
                         int streams) {
  LayerOptics optics;
  optics.moments = Eigen::VectorXd::Zero(streams);
  double albedo = 0.0;
  double forward = 0.0;
  for (const Scatterer& scatterer : column.scatterers) {
    const double share = scatterer.scattering_depth[layer] / column.extinction_depth[layer];
    optics.scatterer_albedos.push_back(share);
    if (share == 0.0) continue;
    albedo += share;
    forward += share * scatterer.phase->moment(streams);
    for (int l = 0; l < streams; ++l) optics.moments[l] += share * scatterer.phase->moment(l);
  }
  // Rounding of the shares must not turn a conservative layer into one that amplifies.
  albedo = std::min(albedo, 1.0);
  if (albedo == 0.0) return optics;
  optics.moments /= optics.moments[0];
  forward = std::max(0.0, forward / albedo);
  optics.forward_fraction = forward;
  optics.depth_factor = 1.0 - forward * albedo;
  optics.scattering_albedo = albedo == 1.0 ? 1.0 : albedo * (1.0 - forward) / optics.depth_factor;
  optics.moments = (optics.moments.array() - forward) / (1.0 - forward);
  if (!matrices.empty()) set_matrix(matrices, forward, optics);
  return optics;
}

std::size_t index_of(std::vector<LayerOptics>& known, LayerOptics optics) {
  const auto found = std::find(known.begin(), known.end(), optics);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  known.push_back(std::move(optics));
  return known.size() - 1;
}

}  // namespace

int streams_for(const OpticalColumn& column, int most) {
  int needed = kFewestStreams;
  for (const Scatterer& scatterer : column.scatterers) {
    if (std::all_of(scatterer.scattering_depth.begin(), scatterer.scattering_depth.end(),
                    [](double depth) { return depth == 0.0; }))
      continue;
    int last = most;
    while (last >= needed && std::abs(scatterer.phase->moment(last)) < kNegligibleMoment) --last;
    needed = std::max(needed, last + 1);
  }
  return std::min(needed + needed % 2, most);
}

ScaledMedium scale_medium(const OpticalColumn& column, const std::vector<double>& output_depths, int streams,
                          bool polarised) {
  double total = 0.0;
  for (double depth : column.extinction_depth) total += depth;
  const double same = kSameDepth * total;
  for (double depth : output_depths)
    if (!(depth >= 0.0 && depth <= total + same))
      throw InputError("output optical depth {}: must lie within the column, 0-{}", depth, total);
  std::vector<double> cuts = output_depths;
  std::sort(cuts.begin(), cuts.end());
  AllMatrixMoments matrices;
  if (polarised)
    for (const Scatterer& scatterer : column.scatterers)
      matrices.push_back(scatterer.phase->matrix_moments(streams - 1));

  ScaledMedium medium;
  medium.streams = streams;
  medium.boundary_depth = {0.0};
  medium.boundary_scaled = {0.0};
  const auto add_slice = [&medium](std::size_t optics, double bottom) {
    const double depth = bottom - medium.boundary_depth.back();
    const double scaled = depth * medium.optics[optics].depth_factor;
    medium.slices.push_back({optics, depth, scaled});
    medium.boundary_depth.push_back(bottom);
    medium.boundary_scaled.push_back(medium.boundary_scaled.back() + scaled);
  };
  double bottom = 0.0;
  for (std::size_t layer = column.extinction_depth.size(); layer-- > 0;) {
    if (column.extinction_depth[layer] == 0.0) continue;
    const std::size_t optics = index_of(medium.optics, layer_optics(column, matrices, layer, streams));
    bottom += column.extinction_depth[layer];
    for (double cut : cuts)
      if (cut > medium.boundary_depth.back() + same && cut < bottom - same) add_slice(optics, cut);
    if (bottom > medium.boundary_depth.back()) add_slice(optics, bottom);
  }
  for (double depth : output_depths) {
    const auto nearest =
        std::min_element(medium.boundary_depth.begin(), medium.boundary_depth.end(),
                         [depth](double a, double b) { return std::abs(a - depth) < std::abs(b - depth); });
    medium.output_bounds.push_back(static_cast<std::size_t>(nearest - medium.boundary_depth.begin()));
  }
  return medium;
}

}  // namespace skylut::plane_parallel
