#include "kernel_rows.hpp"

#include <cmath>

namespace skylut::plane_parallel {
namespace {

KernelRows empty_rows(const Ordinates& ordinates, Eigen::Index count) {
  const Eigen::Index parts = ordinates.polarised ? 3 : 1;
  return {Eigen::MatrixXd::Zero(count, parts * ordinates.legendre.cols()),
          Eigen::MatrixXd::Zero(count, parts * ordinates.legendre_view.cols()), Eigen::VectorXd::Zero(count),
          Eigen::VectorXd::Zero(count)};
}

double scale_of(const LayerOptics& optics, Eigen::Index l) {
  return optics.scattering_albedo * (2.0 * static_cast<double>(l) + 1.0);
}

KernelRows scalar_rows(const LayerOptics& optics, const Ordinates& ordinates, int parity) {
  const Eigen::Index count = (ordinates.legendre.rows() - parity + 1) / 2;
  KernelRows taken = empty_rows(ordinates, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index row = 2 * k + parity;
    const Eigen::Index l = row + ordinates.mode;
    taken.nodes.row(k) = ordinates.legendre.row(row);
    taken.views.row(k) = ordinates.legendre_view.row(row);
    taken.sun[k] = ordinates.legendre_sun[row];
    taken.weight[k] = scale_of(optics, l) * optics.moments[l];
  }
  return taken;
}

/// Writes first · (row of I) + second · (row of Q) of degree row + m into row k of a kernel.
void add_block_row(const Eigen::MatrixXd& legendre, const PolarisedFunctions& functions, Eigen::Index row,
                   double first, double second, Eigen::MatrixXd& into, Eigen::Index k) {
  const Eigen::Index n = legendre.cols();
  into.row(k).segment(0, n) = first * legendre.row(row);
  into.row(k).segment(n, n) = second * functions.r.row(row);
  into.row(k).segment(2 * n, n) = -second * functions.t.row(row);
}

void add_u_row(const PolarisedFunctions& functions, Eigen::Index row, Eigen::MatrixXd& into, Eigen::Index k) {
  const Eigen::Index n = functions.r.cols();
  into.row(k).segment(n, n) = -functions.t.row(row);
  into.row(k).segment(2 * n, n) = functions.r.row(row);
}

KernelRows vector_rows(const LayerOptics& optics, const Ordinates& ordinates, int parity) {
  const Eigen::Index degrees = ordinates.legendre.rows();
  const Eigen::Index blocks = (degrees - parity + 1) / 2;
  KernelRows taken = empty_rows(ordinates, 2 * blocks + (degrees - blocks));
  Eigen::Index k = 0;
  for (Eigen::Index row = 0; row < degrees; ++row) {
    const Eigen::Index l = row + ordinates.mode;
    const double scale = scale_of(optics, l);
    if (row % 2 != parity) {
      add_u_row(ordinates.functions, row, taken.nodes, k);
      add_u_row(ordinates.functions_view, row, taken.views, k);
      taken.weight[k++] = scale * optics.alpha3[l];
      continue;
    }
    // [[a, b], [b, d]] = w1 v1 v1ᵀ + w2 v2 v2ᵀ with v1 = (c, s), v2 = (-s, c).
    const double a = optics.moments[l];
    const double b = optics.beta1[l];
    const double d = optics.alpha2[l];
    const double turn = 0.5 * std::atan2(2.0 * b, a - d);
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    for (const auto& [first, second] : {std::pair{c, s}, std::pair{-s, c}}) {
      add_block_row(ordinates.legendre, ordinates.functions, row, first, second, taken.nodes, k);
      add_block_row(ordinates.legendre_view, ordinates.functions_view, row, first, second, taken.views, k);
      taken.sun[k] = first * ordinates.legendre_sun[row];
      taken.weight[k++] = scale * (first * first * a + 2.0 * first * second * b + second * second * d);
    }
  }
  return taken;
}

bool any(const Eigen::VectorXd& moments, Eigen::Index last) {
  return moments.tail(last).cwiseAbs().maxCoeff() > 0.0;
}

}  // namespace

KernelRows kernel_rows(const LayerOptics& optics, const Ordinates& ordinates, int parity) {
  return ordinates.polarised ? vector_rows(optics, ordinates, parity)
                             : scalar_rows(optics, ordinates, parity);
}

bool scatters_in_mode(const LayerOptics& optics, const Ordinates& ordinates) {
  const Eigen::Index rows = ordinates.legendre.rows();
  if (!(optics.scattering_albedo > 0.0)) return false;
  if (any(optics.moments, rows)) return true;
  return ordinates.polarised &&
         (any(optics.alpha2, rows) || any(optics.alpha3, rows) || any(optics.beta1, rows));
}

}  // namespace skylut::plane_parallel
