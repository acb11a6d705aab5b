#include "source_integration.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::plane_parallel {
namespace {

/// Below this kT, sinh(kt)/sinh(kT) is t/T to better than (kT)²/6 = 2e-9, and its exponentials would cancel.
constexpr double kLinear = 1e-4;

/// Weights of x_j(0), x_j(T) in x_j(t) = x(0) sinh(k(T-t))/sinh(kT) + x(T) sinh(kt)/sinh(kT), and in
/// its derivative, integrated along a view: ∫ x e^{-s/μ} ds/μ, s the distance to the side looked from.
struct ModeIntegral {
  double near = 0.0;             ///< of x at the side towards the observer
  double far = 0.0;              ///< of x at the other side
  double derivative_near = 0.0;  ///< of the same in ∫ (dx/ds) e^{-s/μ} ds/μ
  double derivative_far = 0.0;
};

ModeIntegral integrate_mode(double k, double mu, double depth) {
  const double exp_view = std::exp(-depth / mu);
  const double all = -std::expm1(-depth / mu);
  if (k * depth < kLinear) {
    const double rising = mu / depth * all - exp_view;  // ∫ (s/T) e^{-s/μ} ds/μ
    return {all - rising, rising, -all / depth, all / depth};
  }
  const double exp_mode = std::exp(-k * depth);
  const double leaving = attenuated_towards_start(k, mu, depth);  // of e^{-ks}
  const double arriving = attenuated_towards_end(k, mu, depth);   // of e^{-k(T-s)}
  const double scale = 1.0 / -std::expm1(-2.0 * k * depth);
  return {scale * (leaving - exp_mode * arriving), scale * (arriving - exp_mode * leaving),
          -k * scale * (leaving + exp_mode * arriving), k * scale * (arriving + exp_mode * leaving)};
}

/// What one slice adds to the radiance at its end nearest to the observer.
double slice_radiance(const LayerModes& modes, Eigen::Index view, double cos_view, double depth,
                      double beam_top, const Eigen::VectorXd& at_top, const Eigen::VectorXd& at_bottom) {
  const bool upward = cos_view > 0.0;
  const double mu = std::abs(cos_view);
  const Eigen::VectorXd& near = upward ? at_top : at_bottom;
  const Eigen::VectorXd& far = upward ? at_bottom : at_top;
  // J(up) = even + odd dx/dτ with s = τ - τ_top; J(down) = even - odd dx/dτ with s = τ_bottom - τ,
  // dx/dτ = -dx/ds: in terms of s both are even + odd dx/ds.
  double sum = 0.0;
  for (Eigen::Index j = 0; j < modes.rate.size(); ++j) {
    const ModeIntegral part = integrate_mode(modes.rate[j], mu, depth);
    sum += modes.view_even(view, j) * (part.near * near[j] + part.far * far[j]) +
           modes.view_odd(view, j) * (part.derivative_near * near[j] + part.derivative_far * far[j]);
  }
  const double beam = upward ? attenuated_towards_start(modes.beam_rate, mu, depth)
                             : attenuated_towards_end(modes.beam_rate, mu, depth);
  const double sign = upward ? 1.0 : -1.0;
  return sum + beam_top * beam * (modes.view_beam_even[view] + sign * modes.view_beam_odd[view]);
}

}  // namespace

double attenuated_towards_start(double a, double mu, double depth) {
  return -std::expm1(-(a + 1.0 / mu) * depth) / (1.0 + a * mu);
}

double attenuated_towards_end(double a, double mu, double depth) {
  // (e^{-aT} - e^{-T/μ}) / (1 - aμ), written so that nothing cancels.
  const double difference = a - 1.0 / mu;
  const double slow = std::exp(-std::min(a, 1.0 / mu) * depth);
  const double size = std::abs(difference);
  const double ratio = size * depth < 1e-12 ? depth : -std::expm1(-size * depth) / size;
  return slow * ratio / mu;
}

Eigen::MatrixXd radiance_at_views(const ScaledMedium& medium, const std::vector<LayerModes>& modes,
                                  const Ordinates& ordinates, const Illumination& light,
                                  const BoundaryFields& fields, const Eigen::VectorXd& cos_views) {
  const std::size_t count = medium.slices.size();
  const auto row = [](std::size_t boundary) { return static_cast<Eigen::Index>(boundary); };
  Eigen::MatrixXd radiance = Eigen::MatrixXd::Zero(row(count + 1), cos_views.size());
  if (ordinates.mode == 0) {
    const double irradiance = 2.0 * kPi * ordinates.flux_root.dot(fields.down[count]) +
                              light.cos_sun * std::exp(-medium.boundary_scaled[count] / light.cos_sun);
    // Light from the ground and from the top is not polarised.
    const Eigen::Index intensities = ordinates.legendre_view.cols();
    for (Eigen::Index view = 0; view < intensities; ++view) {
      if (cos_views[view] < 0.0) radiance(0, view) = light.isotropic_top;
      if (cos_views[view] > 0.0) radiance(row(count), view) = light.ground_albedo / kPi * irradiance;
    }
  }
  // Inner light of each slice: from GᵀH = 1, x = Hᵀ(σ - σ_beam) at its two ends.
  std::vector<Eigen::VectorXd> at_top(count);
  std::vector<Eigen::VectorXd> at_bottom(count);
  for (std::size_t b = 0; b < count; ++b) {
    const LayerModes& layer = modes[medium.slices[b].optics];
    if (!layer.scatters) continue;
    const double beam_top = std::exp(-medium.boundary_scaled[b] / light.cos_sun);
    const double beam_bottom = beam_top * std::exp(-layer.beam_rate * medium.slices[b].scaled_depth);
    at_top[b] =
        layer.difference_modes.transpose() * (fields.up[b] + fields.down[b] - beam_top * layer.beam_sum);
    at_bottom[b] = layer.difference_modes.transpose() *
                   (fields.up[b + 1] + fields.down[b + 1] - beam_bottom * layer.beam_sum);
  }
  for (Eigen::Index view = 0; view < cos_views.size(); ++view) {
    const bool upward = cos_views[view] > 0.0;
    for (std::size_t step = 0; step < count; ++step) {
      const std::size_t b = upward ? count - 1 - step : step;
      const Slice& slice = medium.slices[b];
      const LayerModes& layer = modes[slice.optics];
      const double source =
          layer.scatters
              ? slice_radiance(layer, view, cos_views[view], slice.scaled_depth,
                               std::exp(-medium.boundary_scaled[b] / light.cos_sun), at_top[b], at_bottom[b])
              : 0.0;
      const std::size_t from = upward ? b + 1 : b;
      const std::size_t to = upward ? b : b + 1;
      radiance(row(to), view) =
          radiance(row(from), view) * std::exp(-slice.scaled_depth / std::abs(cos_views[view])) + source;
    }
  }
  return radiance;
}

}  // namespace skylut::plane_parallel
