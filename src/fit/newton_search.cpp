#include "newton_search.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace skylut::fit_detail {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Local {
  double cost = std::numeric_limits<double>::infinity();
  VectorXd gradient;
  VectorXd scale;  // length of the Jacobian's columns, 1 for a column of zeros
};

class NewtonSearch {
 public:
  NewtonSearch(const ceres::CostFunction& residuals, const std::vector<ParameterBounds>& bounds)
      : residuals_(residuals),
        bounds_(bounds),
        count_(static_cast<Index>(bounds.size())),
        residual_(residuals.num_residuals()),
        jacobian_(residuals.num_residuals(), count_) {}

  // Residuals that are not finite have infinite cost.
  Local at(const VectorXd& x) {
    Local local;
    const double* blocks[] = {x.data()};
    double* derivatives[] = {jacobian_.data()};
    if (!residuals_.Evaluate(blocks, residual_.data(), derivatives)) return local;
    local.gradient = jacobian_.transpose() * residual_;
    local.scale = jacobian_.colwise().norm().transpose();
    for (double& length : local.scale)
      if (!(length > 0.0)) length = 1.0;
    if (residual_.allFinite() && jacobian_.allFinite()) local.cost = 0.5 * residual_.squaredNorm();
    return local;
  }

  // Central differences of the gradient; the step balances rounding against the third derivative, for
  // parameters that are logarithms or of the order of 1 and more.
  Eigen::MatrixXd hessian(const VectorXd& x) {
    constexpr double kStep = 6e-6;  // cube root of the rounding of a double
    Eigen::MatrixXd hessian(count_, count_);
    for (Index i = 0; i < count_; ++i) {
      const double step = kStep * std::max(std::abs(x(i)), 1.0);
      VectorXd up = x;
      VectorXd down = x;
      up(i) += step;
      down(i) -= step;
      const Local above = at(up);
      const Local below = at(down);
      if (!std::isfinite(above.cost) || !std::isfinite(below.cost)) return Eigen::MatrixXd();
      hessian.col(i) = (above.gradient - below.gradient) / (up(i) - down(i));
    }
    return 0.5 * (hessian + hessian.transpose());
  }

  // Parameters that the gradient does not push against a bound.
  std::vector<Index> free_parameters(const VectorXd& x, const VectorXd& gradient) const {
    std::vector<Index> free;
    for (Index i = 0; i < count_; ++i) {
      const ParameterBounds& bound = bounds_[static_cast<std::size_t>(i)];
      const bool held =
          (x(i) <= bound.lower && gradient(i) >= 0.0) || (x(i) >= bound.upper && gradient(i) <= 0.0);
      if (!held) free.push_back(i);
    }
    return free;
  }

  VectorXd within_bounds(VectorXd x) const {
    for (Index i = 0; i < count_; ++i) {
      const ParameterBounds& bound = bounds_[static_cast<std::size_t>(i)];
      x(i) = std::clamp(x(i), bound.lower, bound.upper);
    }
    return x;
  }

 private:
  const ceres::CostFunction& residuals_;
  const std::vector<ParameterBounds>& bounds_;
  const Index count_;
  VectorXd residual_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian_;
};

// The quadratic model around a point along its principal axes, in parameters scaled by the Jacobian's
// columns.
struct Quadratic {
  std::vector<Index> free;
  VectorXd scale;      // of the free parameters
  VectorXd curvature;  // eigenvalues, rising
  Eigen::MatrixXd axes;
  VectorXd slope;  // the gradient along the axes

  Quadratic(std::vector<Index> free_parameters, const Local& here, const Eigen::MatrixXd& hessian)
      : free(std::move(free_parameters)), scale(here.scale(free)) {
    const VectorXd inverse = scale.cwiseInverse();
    const Eigen::MatrixXd scaled = inverse.asDiagonal() * hessian(free, free) * inverse.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    curvature = eigen.eigenvalues();
    axes = eigen.eigenvectors();
    slope = axes.transpose() * inverse.asDiagonal() * here.gradient(free);
  }

  // An eigenvalue of this share of the largest is 0 within the rounding of the differences.
  double smallest_curvature() const { return 1e-10 * curvature.cwiseAbs().maxCoeff(); }
  bool convex() const { return curvature(0) >= -smallest_curvature(); }

  // How far the cost lies above the model's minimum.
  double excess() const {
    return 0.5 * (slope.array().square() / curvature.array().abs().max(smallest_curvature())).sum();
  }

  // Step of all parameters; along an axis of negative curvature downhill too.
  VectorXd step(double damping, Index count) const {
    const VectorXd along = slope.array() / (curvature.array().abs().max(smallest_curvature()) + damping);
    const VectorXd free_step = -(scale.cwiseInverse().asDiagonal() * (axes * along));
    VectorXd step = VectorXd::Zero(count);
    step(free) = free_step;
    return step;
  }
};

constexpr double kTolerance = 1e-14;  // of the cost, as the Levenberg-Marquardt runs have it
constexpr double kRounding = 1e-10;   // of the cost: what rounding may hide of a fall

}  // namespace

Minimum newton_search(const ceres::CostFunction& residuals, const std::vector<ParameterBounds>& bounds,
                      Minimum from, int max_iterations) {
  constexpr int kMostDampings = 30;
  NewtonSearch search(residuals, bounds);
  VectorXd x = Eigen::Map<const VectorXd>(from.at.data(), static_cast<Index>(from.at.size()));
  Local here = search.at(x);
  const auto end = [&](Termination termination, const char* message) {
    from.at.assign(x.begin(), x.end());
    from.cost = here.cost;
    from.termination = termination;
    from.message = message;
    return from;
  };
  double damping = 0.0;
  for (int iteration = 0; iteration < max_iterations; ++iteration, ++from.iterations) {
    const std::vector<Index> free = search.free_parameters(x, here.gradient);
    if (free.empty()) return end(Termination::converged, "all parameters are held by their bounds");
    const Eigen::MatrixXd hessian = search.hessian(x);
    if (hessian.size() == 0) break;
    const Quadratic model(free, here, hessian);
    if (model.convex() && model.excess() <= kTolerance * here.cost)
      return end(Termination::converged, "Newton: the cost cannot fall by more than 1e-14 of itself");
    const double least_damping = 1e-3 * model.curvature.cwiseAbs().maxCoeff();
    bool lower = false;
    for (int attempt = 0; attempt < kMostDampings && !lower; ++attempt) {
      const VectorXd there_at = search.within_bounds(x + model.step(damping, x.size()));
      const Local there = search.at(there_at);
      lower = there.cost < here.cost;
      if (lower) {
        x = there_at;
        here = there;
        damping = damping > least_damping ? 0.1 * damping : 0.0;
      } else {
        damping = std::max(10.0 * damping, least_damping);
      }
    }
    if (!lower && model.convex() && model.excess() <= kRounding * here.cost)
      return end(Termination::converged, "Newton: no step lowers the cost in double precision");
    if (!lower)
      return end(Termination::no_convergence, "Newton: no step lowers the cost, which is no minimum");
  }
  return end(Termination::no_convergence, "maximum number of iterations reached");
}

}  // namespace skylut::fit_detail
