#include "multistart.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace skylut::fit_detail {

namespace {

// Levenberg-Marquardt on one set of residuals, from any start.
class LocalSearch {
 public:
  LocalSearch(ceres::CostFunction& residuals, const std::vector<ParameterBounds>& bounds)
      : bounds_(bounds), at_(bounds.size()), problem_(problem_options()) {
    problem_.AddResidualBlock(&residuals, nullptr, at_.data());
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const int index = static_cast<int>(i);
      if (std::isfinite(bounds[i].lower)) problem_.SetParameterLowerBound(at_.data(), index, bounds[i].lower);
      if (std::isfinite(bounds[i].upper)) problem_.SetParameterUpperBound(at_.data(), index, bounds[i].upper);
    }
  }

  Minimum run(const Start& start, double tolerance, int max_iterations) {
    for (std::size_t i = 0; i < at_.size(); ++i)
      at_[i] = std::clamp(start[i], bounds_[i].lower, bounds_[i].upper);
    if (!has_value()) return {};
    const ceres::Solver::Options solver = solver_options(tolerance, max_iterations);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    int iterations = steps(summary);
    // At a bound Ceres cuts every step short: go on along the bound.
    const std::vector<int> fixed = at_bound();
    if (!fixed.empty()) {
      problem_.SetManifold(at_.data(), new ceres::SubsetManifold(static_cast<int>(at_.size()), fixed));
      ceres::Solve(solver, &problem_, &summary);
      problem_.SetManifold(at_.data(), nullptr);
      iterations += steps(summary);
    }
    Minimum result;
    if (!summary.IsSolutionUsable()) return result;
    result.cost = summary.final_cost;
    result.at = at_;
    result.termination =
        summary.termination_type == ceres::CONVERGENCE ? Termination::converged : Termination::no_convergence;
    result.message = summary.message;
    result.iterations = iterations;
    return result;
  }

 private:
  static ceres::Problem::Options problem_options() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  static ceres::Solver::Options solver_options(double tolerance, int max_iterations) {
    ceres::Solver::Options options;
    options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
    options.linear_solver_type = ceres::DENSE_QR;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = max_iterations;
    options.function_tolerance = tolerance;
    options.parameter_tolerance = 1e-13;
    options.gradient_tolerance = 1e-15;
    return options;
  }

  // Where not, Ceres would say so on standard error.
  bool has_value() {
    ceres::Problem::EvaluateOptions options;
    options.apply_loss_function = false;
    double cost = 0.0;
    std::vector<double> gradient;
    return problem_.Evaluate(options, &cost, nullptr, &gradient, nullptr) && std::isfinite(cost);
  }

  // The first entry is the start.
  static int steps(const ceres::Solver::Summary& summary) {
    return std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  }

  std::vector<int> at_bound() const {
    std::vector<int> fixed;
    for (std::size_t i = 0; i < at_.size(); ++i)
      if (at_[i] <= bounds_[i].lower || at_[i] >= bounds_[i].upper) fixed.push_back(static_cast<int>(i));
    return fixed;
  }

  const std::vector<ParameterBounds>& bounds_;
  std::vector<double> at_;  // Ceres holds its address
  ceres::Problem problem_;
};

}  // namespace

Minimum multistart(ceres::CostFunction& residuals, const std::vector<ParameterBounds>& bounds,
                   const std::vector<Start>& starts, int max_iterations) {
  constexpr double kRough = 1e-5;
  constexpr int kRoughIterations = 30;
  constexpr double kThorough = 1e-14;
  constexpr std::size_t kBest = 2;
  LocalSearch search(residuals, bounds);
  std::vector<Minimum> ends;
  for (const Start& start : starts) {
    Minimum end = search.run(start, kRough, std::min(kRoughIterations, max_iterations));
    if (std::isfinite(end.cost)) ends.push_back(std::move(end));
  }
  std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  Minimum best;
  for (std::size_t i = 0; i < std::min(ends.size(), kBest); ++i) {
    Minimum end = search.run(ends[i].at, kThorough, max_iterations);
    end.iterations += ends[i].iterations;
    if (end.cost < best.cost) best = std::move(end);
  }
  return best;
}

}  // namespace skylut::fit_detail
