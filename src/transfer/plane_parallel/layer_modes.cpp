#include "layer_modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

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

/// Rows of Λ with l+m even (parity 0) or odd (1), and the weights ω (2l+1) χ_l.
struct Parity {
  Eigen::MatrixXd nodes;
  Eigen::MatrixXd views;
  Eigen::VectorXd sun;
  Eigen::VectorXd weight;
};

Parity take_parity(const LayerOptics& optics, const Ordinates& ordinates, int parity) {
  const Eigen::Index rows = ordinates.legendre.rows();
  const Eigen::Index count = (rows - parity + 1) / 2;
  Parity taken{{count, ordinates.legendre.cols()},
               {count, ordinates.legendre_view.cols()},
               Eigen::VectorXd(count),
               Eigen::VectorXd(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index row = 2 * k + parity;
    const Eigen::Index l = row + ordinates.mode;
    taken.nodes.row(k) = ordinates.legendre.row(row);
    taken.views.row(k) = ordinates.legendre_view.row(row);
    taken.sun[k] = ordinates.legendre_sun[row];
    taken.weight[k] = optics.scattering_albedo * (2.0 * static_cast<double>(l) + 1.0) * optics.moments[l];
  }
  return taken;
}

double beam_rate_off_resonance(double cos_sun, const Eigen::VectorXd& rate) {
  const double wanted = 1.0 / cos_sun;
  double used = wanted;
  for (int attempt = 1; (rate.array() / used - 1.0).abs().minCoeff() < kResonance; ++attempt)
    used = wanted * (1.0 + 2.0 * kResonance * attempt);
  return used;
}

}  // namespace

Ordinates make_ordinates(int streams, int mode, double cos_sun, const Eigen::VectorXd& cos_views) {
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
  return ordinates;
}

LayerModes solve_layer_modes(const LayerOptics& optics, const Ordinates& ordinates, double cos_sun) {
  LayerModes modes;
  const Eigen::Index rows = ordinates.legendre.rows();
  modes.scatters = optics.scattering_albedo > 0.0 && optics.moments.tail(rows).cwiseAbs().maxCoeff() > 0.0;
  if (!modes.scatters) return modes;

  const Parity even = take_parity(optics, ordinates, 0);
  const Parity odd = take_parity(optics, ordinates, 1);
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
