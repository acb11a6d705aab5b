#include "layer_modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "kernel_rows.hpp"
#include "normalised_legendre.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut::plane_parallel {
namespace {

/// The particular solution divides by λ² - K²: below this relative distance the beam's rate is moved, which
/// changes the beam by less than 1e-7; at the distance itself 9 of 16 digits remain.
constexpr double kResonance = 1e-7;

/// K² is never negative for a phase function that is nowhere negative; rounding leaves some 1e-14 of the
/// largest.
constexpr double kRounding = 1e-12;
constexpr const char* kImpossiblePhase =
    "a layer's Legendre moments make it scatter more than it receives: must be those of a phase function >= "
    "0";

double beam_rate_off_resonance(double cos_sun, const Eigen::VectorXd& rate) {
  const double wanted = 1.0 / cos_sun;
  double used = wanted;
  for (int attempt = 1; (rate.array() / used - 1.0).abs().minCoeff() < kResonance; ++attempt)
    used = wanted * (1.0 + 2.0 * kResonance * attempt);
  return used;
}

}  // namespace

Ordinates make_ordinates(int streams, int mode, double cos_sun, const Eigen::VectorXd& cos_views,
                         bool polarised) {
  const Quadrature rule = gauss_legendre(streams / 2, 0.0, 1.0);
  Ordinates ordinates;
  ordinates.mode = mode;
  ordinates.mu = Eigen::Map<const Eigen::VectorXd>(rule.node.data(), streams / 2);
  const Eigen::Map<const Eigen::VectorXd> weight(rule.weight.data(), streams / 2);
  ordinates.flux_root = (weight.array() * ordinates.mu.array()).sqrt();
  const Eigen::VectorXd root = (weight.array() / ordinates.mu.array()).sqrt();
  ordinates.legendre = normalised_legendre(mode, streams, ordinates.mu) * root.asDiagonal();
  ordinates.legendre_sun = normalised_legendre(mode, streams, Eigen::VectorXd::Constant(1, cos_sun)).col(0);
  ordinates.legendre_view = normalised_legendre(mode, streams, cos_views.cwiseAbs());
  if (!polarised) return ordinates;
  ordinates.polarised = true;
  ordinates.functions = polarised_functions(mode, streams, ordinates.mu);
  ordinates.functions.r *= root.asDiagonal();
  ordinates.functions.t *= root.asDiagonal();
  ordinates.functions_view = polarised_functions(mode, streams, cos_views.cwiseAbs());
  const Eigen::Index nodes = ordinates.mu.size();
  ordinates.mu = ordinates.mu.replicate(3, 1).eval();
  ordinates.flux_root.conservativeResizeLike(Eigen::VectorXd::Zero(3 * nodes));
  return ordinates;
}

LayerModes solve_layer_modes(const LayerOptics& optics, const Ordinates& ordinates, double cos_sun) {
  LayerModes modes;
  modes.scatters = scatters_in_mode(optics, ordinates);
  if (!modes.scatters) return modes;

  const KernelRows even = kernel_rows(optics, ordinates, 0);
  const KernelRows odd = kernel_rows(optics, ordinates, 1);
  const Eigen::MatrixXd inverse_mu = ordinates.mu.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd a = inverse_mu - odd.nodes.transpose() * odd.weight.asDiagonal() * odd.nodes;
  const Eigen::MatrixXd b = inverse_mu - even.nodes.transpose() * even.weight.asDiagonal() * even.nodes;

  const Eigen::LLT<Eigen::MatrixXd> cholesky(a);
  if (cholesky.info() != Eigen::Success) throw WorkError(kImpossiblePhase);
  const Eigen::MatrixXd lower = cholesky.matrixL();
  const Eigen::MatrixXd product = lower.transpose() * b * lower;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(product);
  if (eigen.info() != Eigen::Success ||
      eigen.eigenvalues().minCoeff() < -kRounding * eigen.eigenvalues().maxCoeff())
    throw WorkError(kImpossiblePhase);
  modes.rate = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  // Isotropic light in a layer that absorbs nothing is the exact solution K = 0 (m = 0 only).
  if (optics.scattering_albedo == 1.0 && ordinates.mode == 0) modes.rate[0] = 0.0;
  modes.sum_modes = lower * eigen.eigenvectors();
  modes.difference_modes = cholesky.matrixU().solve(eigen.eigenvectors());

  // Particular solution for the beam: x_p = ρ/(λ²-K²) e^{-λτ}, ρ = Vᵀ(λL⁻¹α - Lᵀβ);
  // δ_p = H x_p' + A⁻¹α. Beam source Q(±μ) = c (E ∓ O), c = (2-δ_m0)/4π: α = -2cO, β = 2cE.
  modes.beam_rate = beam_rate_off_resonance(cos_sun, modes.rate);
  const double c = (ordinates.mode == 0 ? 1.0 : 2.0) / (4.0 * kPi);
  const Eigen::VectorXd alpha = -2.0 * c * (odd.nodes.transpose() * odd.weight.cwiseProduct(odd.sun));
  const Eigen::VectorXd beta = 2.0 * c * (even.nodes.transpose() * even.weight.cwiseProduct(even.sun));
  const Eigen::VectorXd lower_alpha = cholesky.matrixL().solve(alpha);
  const Eigen::VectorXd rho =
      eigen.eigenvectors().transpose() * (modes.beam_rate * lower_alpha - lower.transpose() * beta);
  const Eigen::VectorXd amplitude =
      rho.array() / ((modes.beam_rate - modes.rate.array()) * (modes.beam_rate + modes.rate.array()));
  modes.beam_sum = modes.sum_modes * amplitude;
  modes.beam_difference =
      cholesky.matrixU().solve(lower_alpha) - modes.beam_rate * (modes.difference_modes * amplitude);

  const Eigen::MatrixXd towards_even = 0.5 * even.views.transpose() * even.weight.asDiagonal() * even.nodes;
  const Eigen::MatrixXd towards_odd = 0.5 * odd.views.transpose() * odd.weight.asDiagonal() * odd.nodes;
  modes.view_even = towards_even * modes.sum_modes;
  modes.view_odd = towards_odd * modes.difference_modes;
  modes.view_beam_even = towards_even * modes.beam_sum;
  modes.view_beam_odd = towards_odd * modes.beam_difference;
  return modes;
}

}  // namespace skylut::plane_parallel
