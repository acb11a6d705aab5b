#include "adding.hpp"

#include <Eigen/LU>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::plane_parallel {
namespace {

/// One slice as an operator on scaled vectors: out = reflection · in (same side) + transmission · in
/// (other side) + emission (light of the beam scattered in the slice).
struct SliceOperator {
  bool scatters = false;
  Eigen::VectorXd direct;  ///< e^{-τ/μ}: the transmission of a slice that does not scatter
  Eigen::MatrixXd reflection;
  Eigen::MatrixXd transmission;
  Eigen::VectorXd emission_up;
  Eigen::VectorXd emission_down;
};

/// k tanh(kT/2) and k coth(kT/2); 0 and 2/T in the limit k → 0.
double rate_tanh(double k, double depth) { return k * std::tanh(0.5 * k * depth); }
double rate_coth(double k, double depth) {
  const double half = 0.5 * k * depth;
  // x coth x = 1 + x²/3 - …: the next term is below 1e-16 for x < 1e-4.
  return half < 1e-4 ? 2.0 / depth * (1.0 + half * half / 3.0) : k / std::tanh(half);
}

/// Light entering equally (with opposite sign) from both sides excites x ∝ cosh (sinh) about the middle
/// of the slice, so R ± T = (G - H X)(G + H X)⁻¹ with X = k tanh(kT/2) for +, k coth(kT/2) for -.
Eigen::MatrixXd symmetric_response(const LayerModes& modes, const Eigen::VectorXd& rates) {
  const Eigen::MatrixXd scaled = modes.difference_modes * rates.asDiagonal();
  const Eigen::MatrixXd incoming = modes.sum_modes + scaled;
  const Eigen::MatrixXd outgoing = modes.sum_modes - scaled;
  // (out · in⁻¹)ᵀ = in⁻ᵀ outᵀ, and the response is symmetric.
  return incoming.transpose().partialPivLu().solve(outgoing.transpose());
}

SliceOperator slice_operator(const LayerModes& modes, const Ordinates& ordinates, double depth,
                             double top_depth, double cos_sun) {
  SliceOperator slice;
  slice.scatters = modes.scatters;
  if (!modes.scatters) {
    slice.direct = (-depth * ordinates.mu.cwiseInverse().array()).exp();
    return slice;
  }
  const Eigen::VectorXd tanh_rates = modes.rate.unaryExpr([depth](double k) { return rate_tanh(k, depth); });
  const Eigen::VectorXd coth_rates = modes.rate.unaryExpr([depth](double k) { return rate_coth(k, depth); });
  const Eigen::MatrixXd plus = symmetric_response(modes, tanh_rates);
  const Eigen::MatrixXd minus = symmetric_response(modes, coth_rates);
  slice.reflection = 0.5 * (plus + minus);
  slice.transmission = 0.5 * (plus - minus);

  // The particular solution less the homogeneous one that cancels what it lets in from outside.
  const double beam_top = std::exp(-top_depth / cos_sun);
  const double beam_bottom = beam_top * std::exp(-depth * modes.beam_rate);
  const Eigen::VectorXd up = 0.5 * (modes.beam_sum + modes.beam_difference);
  const Eigen::VectorXd down = 0.5 * (modes.beam_sum - modes.beam_difference);
  slice.emission_up =
      beam_top * up - slice.reflection * (beam_top * down) - slice.transmission * (beam_bottom * up);
  slice.emission_down =
      beam_bottom * down - slice.transmission * (beam_top * down) - slice.reflection * (beam_bottom * up);
  return slice;
}

/// What lies below one boundary: up = reflection · down + emission.
struct Below {
  Eigen::MatrixXd reflection;
  Eigen::VectorXd emission;
};

Below ground(const Ordinates& ordinates, const Illumination& light, double total_depth) {
  const Eigen::Index n = ordinates.mu.size();
  Below below{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  if (ordinates.mode > 0 || light.ground_albedo == 0.0) return below;
  // Lambert: I⁺ = A/π · irradiance, irradiance = 2π Σ (wμ)^½ ι⁻ + μ0 e^{-τ/μ0}.
  below.reflection = 2.0 * light.ground_albedo * ordinates.flux_root * ordinates.flux_root.transpose();
  const double beam = light.cos_sun * std::exp(-total_depth / light.cos_sun);
  below.emission = light.ground_albedo / kPi * beam * ordinates.flux_root;
  return below;
}

/// Light below a slice: down = transfer · (down above it) + source.
struct Through {
  Eigen::MatrixXd transfer;
  Eigen::VectorXd source;
};

}  // namespace

BoundaryFields join_slices(const ScaledMedium& medium, const std::vector<LayerModes>& modes,
                           const Ordinates& ordinates, const Illumination& light) {
  const std::size_t count = medium.slices.size();
  const Eigen::Index n = ordinates.mu.size();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  std::vector<Below> below(count + 1);
  std::vector<Through> through(count);
  below[count] = ground(ordinates, light, medium.boundary_scaled.back());
  for (std::size_t b = count; b-- > 0;) {
    const Slice& slice = medium.slices[b];
    const SliceOperator layer = slice_operator(modes[slice.optics], ordinates, slice.scaled_depth,
                                               medium.boundary_scaled[b], light.cos_sun);
    const Below& under = below[b + 1];
    if (!layer.scatters) {
      through[b] = {layer.direct.asDiagonal(), Eigen::VectorXd::Zero(n)};
      below[b] = {layer.direct.asDiagonal() * under.reflection * layer.direct.asDiagonal(),
                  layer.direct.asDiagonal() * under.emission};
      continue;
    }
    // Light bouncing between the slice and what lies under it: D = T i + R U + S, U = R_b D + s_b.
    const Eigen::PartialPivLU<Eigen::MatrixXd> bounces(identity - layer.reflection * under.reflection);
    through[b].transfer = bounces.solve(layer.transmission);
    through[b].source = bounces.solve(layer.reflection * under.emission + layer.emission_down);
    const Eigen::MatrixXd back = layer.transmission * under.reflection;
    below[b].reflection = layer.reflection + back * through[b].transfer;
    below[b].emission = layer.emission_up + back * through[b].source + layer.transmission * under.emission;
  }

  BoundaryFields fields;
  const double top = ordinates.mode == 0 ? light.isotropic_top : 0.0;
  fields.down.push_back(top * ordinates.flux_root);
  for (std::size_t b = 0; b <= count; ++b) {
    fields.up.push_back(below[b].reflection * fields.down[b] + below[b].emission);
    if (b < count) fields.down.push_back(through[b].transfer * fields.down[b] + through[b].source);
  }
  return fields;
}

}  // namespace skylut::plane_parallel
