#include "local_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "zenith_offset.hpp"

namespace skylut::fit_detail {

using Eigen::ArrayXd;
using Eigen::Index;

LocalSearch::LocalSearch(const FitProblem& problem, const FitOptions& options)
    : problem_(problem), options_(options), aureole_(static_cast<Index>(problem.observations.size())) {
  constexpr double kFlattestLevel = 40.0;  // a to -2e17: any
  lower_ = {-std::min(std::log(options.largest_gradation), kFlattestLevel), std::log(-options.B_upper),
            options.D_lower};
  upper_ = {kFlattestLevel, std::log(-options.B_lower), options.D_upper};
  least_offset_ = 1.0 / options.largest_scattering;
  const auto n = static_cast<Index>(problem.observations.size());
  for (ArrayXd* array : {&h_, &t_, &K_, &away_, &U_, &U_slope_, &level_, &w_, &k_, &base_, &residual_})
    array->resize(n);
  for (Index i = 0; i < n; ++i) {
    const Observation& o = problem.observations[static_cast<std::size_t>(i)];
    h_(i) = o.model_scale;
    t_(i) = o.target;
    K_(i) = o.cos2_excess;
    away_(i) = o.gamma_rad - problem.sun.sun_zenith_rad;
  }
  const auto rings = static_cast<Index>(problem.ring_begins.size()) - 1;
  for (ArrayXd* array : {&ring_excess_, &ring_U_, &ring_slope_}) array->resize(rings);
  for (Index ring = 0; ring < rings; ++ring)
    ring_excess_(ring) =
        problem.observations[problem.ring_begins[static_cast<std::size_t>(ring)]].secant_excess;
}

LocalSearch::Point LocalSearch::within_bounds(const Point& point) const {
  return {std::clamp(point.log_level, lower_.log_level, upper_.log_level),
          std::clamp(point.log_rate, lower_.log_rate, upper_.log_rate),
          std::clamp(point.D, lower_.D, upper_.D)};
}

// c and e by Gram-Schmidt: K, then W made orthogonal to it. Where they would leave p below its bound, along
// the line that keeps it there. Leaves the residuals, and in w_ and k_ an orthogonal basis of what was
// eliminated.
void LocalSearch::eliminate(double D) {
  const double KK = k_.square().sum();
  has_k_ = KK > 0.0;
  const double KW = (k_ * w_).sum();
  const double KR = (k_ * base_).sum();
  const double WW = w_.square().sum();
  const double share = has_k_ ? KW / KK : 0.0;
  const ZenithOffset offset(D, problem_.sun);
  // A column that is dependent to 12 digits is left out.
  const ArrayXd& w = w_;
  residual_ = w - share * k_;  // borrowed for the orthogonal column
  const double rest = residual_.square().sum();
  has_w_ = rest > 1e-24 * WW;
  const double first_e = has_k_ ? -KR / KK : 0.0;
  c_ = has_w_ ? -(residual_ * (base_ + first_e * k_)).sum() / rest : 0.0;
  e_ = first_e - c_ * share;
  c_D_ = e_D_ = 0.0;
  held_ = offset.at(c_, e_) < least_offset_;
  if (held_) {
    const ZenithOffset::Line line = offset.line(least_offset_);
    const ArrayXd along = line.c_along * w_ + line.e_along * k_;
    const ArrayXd from = base_ + line.c * w_ + line.e * k_;
    const double square = along.square().sum();
    const double t = square > 0.0 ? -(from * along).sum() / square : 0.0;
    c_ = line.c + t * line.c_along;
    e_ = line.e + t * line.e_along;
    c_D_ = line.c_D + t * line.c_along_D;
    e_D_ = line.e_D + t * line.e_along_D;
    residual_ = from + t * along;
    has_w_ = false;
    has_k_ = square > 0.0;
    k_ = along;
  } else {
    w_ = residual_;
    residual_ = base_ + (e_ + c_ * share) * k_ + c_ * w_;
  }
}

double LocalSearch::cost_at(const Point& point) {
  a_ = -std::expm1(point.log_level);
  const double B = -std::exp(point.log_rate);
  const Index rings = ring_excess_.size();
  for (Index ring = 0; ring < rings; ++ring) {
    const double excess = ring_excess_(ring);
    const double U = gradation_basis(B, excess);
    const double slope = std::isinf(excess) ? 0.0 : B * excess * (1.0 + U);
    const auto from = static_cast<Index>(problem_.ring_begins[static_cast<std::size_t>(ring)]);
    const auto to = static_cast<Index>(problem_.ring_begins[static_cast<std::size_t>(ring) + 1]);
    U_.segment(from, to - from) = U;
    U_slope_.segment(from, to - from) = slope;
  }
  level_ = h_ * (1.0 + a_ * U_);
  aureole_.set(point.D, away_, problem_.sun, true);
  w_ = level_ * aureole_.W;
  k_ = level_ * K_;
  base_ = level_ - t_;
  eliminate(point.D);
  const double cost = 0.5 * residual_.square().sum();
  return std::isfinite(cost) ? cost : std::numeric_limits<double>::infinity();
}

// Of the point that cost_at() was asked for last.
LocalSearch::Local LocalSearch::local_here() const {
  const ArrayXd scattering = 1.0 + c_ * aureole_.W + e_ * K_;
  Eigen::ArrayXXd J(h_.size(), 3);
  J.col(0) = (a_ - 1.0) * h_ * U_ * scattering;
  J.col(1) = a_ * h_ * U_slope_ * scattering;
  J.col(2) = level_ * (c_ * aureole_.W_D + c_D_ * aureole_.W + e_D_ * K_);
  const auto without = [&J](const ArrayXd& column) {
    const double square = column.square().sum();
    for (Index i = 0; i < 3; ++i) J.col(i) -= ((J.col(i) * column).sum() / square) * column;
  };
  if (has_k_) without(k_);
  if (has_w_) without(w_);
  Local local;
  local.cost = 0.5 * residual_.square().sum();
  local.gradient = J.matrix().transpose() * residual_.matrix();
  local.curvature = J.matrix().transpose() * J.matrix();
  return local;
}

Minimum LocalSearch::run(const Start& start, double tolerance, int iterations) {
  constexpr int kMostDampings = 20;
  Point at = within_bounds({std::log(std::max(1.0 - start[0], 1e-300)), std::log(-start[1]), start[2]});
  double cost = cost_at(at);
  Minimum end;
  if (!std::isfinite(cost)) return end;
  end.termination = Termination::no_convergence;
  end.message = "maximum number of iterations reached";
  double damping = 1e-3;
  for (; end.iterations < iterations; ++end.iterations) {
    const Local here = local_here();
    // Parameters that the gradient pushes against a bound stay there.
    const double x[] = {at.log_level, at.log_rate, at.D};
    const double low[] = {lower_.log_level, lower_.log_rate, lower_.D};
    const double high[] = {upper_.log_level, upper_.log_rate, upper_.D};
    Eigen::Vector3d gradient = here.gradient;
    Eigen::Matrix3d curvature = here.curvature;
    for (int i = 0; i < 3; ++i)
      if ((x[i] <= low[i] && gradient(i) >= 0.0) || (x[i] >= high[i] && gradient(i) <= 0.0) ||
          !(curvature(i, i) > 0.0)) {
        gradient(i) = 0.0;
        curvature.row(i).setZero();
        curvature.col(i).setZero();
        curvature(i, i) = 1.0;
      }
    bool lower = false;
    for (int attempt = 0; attempt < kMostDampings && !lower; ++attempt) {
      Eigen::Matrix3d damped = curvature;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::Vector3d step = -damped.ldlt().solve(gradient);
      const double predicted = -0.5 * gradient.dot(step);
      if (!(predicted > tolerance * cost)) {
        end.termination = Termination::converged;
        end.message = "the cost cannot fall by more than the tolerance";
        break;
      }
      // A logarithm by more than 2, or D by more than itself, is beyond what the slope knows.
      double share = 1.0;
      for (int i = 0; i < 2; ++i) share = std::min(share, 2.0 / std::max(std::abs(step(i)), 1e-300));
      share = std::min(share, std::max(2.0, std::abs(at.D)) / std::max(std::abs(step(2)), 1e-300));
      const Point there = within_bounds(
          {at.log_level + share * step(0), at.log_rate + share * step(1), at.D + share * step(2)});
      const double cost_there = cost_at(there);
      lower = cost_there < cost;
      if (lower) {
        at = there;
        cost = cost_there;
        damping = std::max(0.1 * damping, 1e-12);
      } else {
        damping *= damping < 1e-6 ? 1e4 : 10.0;
      }
    }
    if (!lower) {
      if (end.termination == Termination::no_convergence) end.message = "no step lowers the cost";
      break;
    }
  }
  end.cost = cost;
  // Exactly on the bound where it is: the flags say so.
  const double B = at.log_rate >= upper_.log_rate   ? options_.B_lower
                   : at.log_rate <= lower_.log_rate ? options_.B_upper
                                                    : -std::exp(at.log_rate);
  end.at = {-std::expm1(at.log_level), B, at.D};
  return end;
}

}  // namespace skylut::fit_detail
