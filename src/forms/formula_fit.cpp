#include "formula_fit.hpp"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "skylut/core/errors.hpp"
#include "skylut/models/bernstein.hpp"

namespace skylut::forms_detail {

namespace {

constexpr int kSteps = 40;       // of Levenberg-Marquardt, on the way
constexpr int kLastSteps = 150;  // of the degree that was asked for

double rms_of(double cost, std::size_t samples) {
  return std::sqrt(2.0 * cost / static_cast<double>(samples));
}

/// Ceres' view of a formula, samples and a degree: one block of residuals in all control points.
class CurveResiduals final : public ceres::CostFunction {
 public:
  CurveResiduals(const SkyFormula& formula, std::span<const FormulaSample> samples, std::size_t degree)
      : formula_(formula), samples_(samples), points_(degree + 1), coefficients_(formula.bounds().size()) {
    set_num_residuals(static_cast<int>(samples.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(coefficients_ * points_));
    std::map<double, std::size_t> known;
    for (const FormulaSample& sample : samples) {
      const auto [place, is_new] = known.emplace(sample.along, bases_.size());
      if (is_new) bernstein_basis(sample.along, bases_.emplace_back(points_));
      basis_of_.push_back(place->second);
    }
  }

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    double* const jacobian = jacobians != nullptr ? jacobians[0] : nullptr;
    std::vector<std::vector<double>> coefficients;
    for (const std::vector<double>& basis : bases_) {
      std::vector<double>& here = coefficients.emplace_back(coefficients_, 0.0);
      for (std::size_t i = 0; i < coefficients_; ++i)
        for (std::size_t j = 0; j < points_; ++j) here[i] += basis[j] * parameters[0][i * points_ + j];
    }
    std::vector<double> gradient(jacobian != nullptr ? coefficients_ : 0);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      const FormulaSample& sample = samples_[s];
      const double value = formula_.value(coefficients[basis_of_[s]], sample.view, gradient);
      residuals[s] = sample.weight * (sample.scale * value - sample.target);
      if (!std::isfinite(residuals[s])) return false;
      if (jacobian == nullptr) continue;
      const std::vector<double>& basis = bases_[basis_of_[s]];
      double* row = jacobian + s * coefficients_ * points_;
      for (std::size_t i = 0; i < coefficients_; ++i)
        for (std::size_t j = 0; j < points_; ++j)
          *row++ = sample.weight * sample.scale * gradient[i] * basis[j];
    }
    return true;
  }

 private:
  const SkyFormula& formula_;
  std::span<const FormulaSample> samples_;
  std::size_t points_;
  std::size_t coefficients_;
  std::vector<std::vector<double>> bases_;  // of each different place along the axis
  std::vector<std::size_t> basis_of_;       // [sample]
};

double cost_of(const CurveResiduals& residuals, const std::vector<double>& at) {
  std::vector<double> r(static_cast<std::size_t>(residuals.num_residuals()));
  const double* const parameters = at.data();
  if (!residuals.Evaluate(&parameters, r.data(), nullptr)) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const double one : r) sum += one * one;
  return 0.5 * sum;
}

/// Goes downhill from `at`. @return the iterations
int descend(const CurveResiduals& residuals, std::span<const CoefficientBounds> bounds, std::size_t points,
            int most_iterations, double tolerance, std::vector<double>& at) {
  ceres::Problem::Options own;
  own.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(own);
  // Ceres takes no const function, and changes none.
  problem.AddResidualBlock(const_cast<CurveResiduals*>(&residuals), nullptr, at.data());  // NOLINT
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto& [lower, upper] = bounds[i / points];
    at[i] = std::clamp(at[i], lower, upper);
    if (std::isfinite(lower)) problem.SetParameterLowerBound(at.data(), static_cast<int>(i), lower);
    if (std::isfinite(upper)) problem.SetParameterUpperBound(at.data(), static_cast<int>(i), upper);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = tolerance;
  options.parameter_tolerance = 1e-9;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.num_successful_steps + summary.num_unsuccessful_steps;
}

/// The linear coefficients of a start, by least squares; the others stay.
void solve_linear(const SkyFormula& formula, std::span<const FormulaSample> samples,
                  const std::vector<std::size_t>& linear, std::vector<double>& at) {
  const auto columns = static_cast<Eigen::Index>(linear.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(columns);
  Eigen::VectorXd row(columns);
  std::vector<double> gradient(at.size());
  for (const FormulaSample& sample : samples) {
    formula.value(at, sample.view, gradient);
    for (Eigen::Index k = 0; k < columns; ++k)
      row[k] = sample.weight * sample.scale * gradient[linear[static_cast<std::size_t>(k)]];
    normal.noalias() += row * row.transpose();
    right += row * (sample.weight * sample.target);
  }
  normal.diagonal() *= 1.0 + 1e-10;
  const Eigen::VectorXd solved = normal.ldlt().solve(right);
  if (!solved.allFinite()) return;
  for (Eigen::Index k = 0; k < columns; ++k) at[linear[static_cast<std::size_t>(k)]] = solved[k];
}

using Costed = std::pair<double, std::vector<double>>;

void sort_by_cost(std::vector<Costed>& all, std::size_t keep) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Costed& a, const Costed& b) { return a.first < b.first; });
  all.resize(std::min(all.size(), keep));
}

/// Constant coefficients, best first.
std::vector<Costed> constant_fits(const SkyFormula& formula, std::span<const FormulaSample> samples,
                                  int& iterations) {
  constexpr std::size_t kRuns = 8;
  const std::vector<CoefficientBounds> bounds = formula.bounds();
  const std::vector<std::size_t> linear = formula.linear();
  const CurveResiduals residuals(formula, samples, 0);
  std::vector<Costed> runs;
  for (std::vector<double> start : formula.starts()) {
    if (!linear.empty()) solve_linear(formula, samples, linear, start);
    const double cost = cost_of(residuals, start);
    if (std::isfinite(cost)) runs.emplace_back(cost, std::move(start));
  }
  if (runs.empty()) throw WorkError("fit of a sky formula: no start has a finite cost");
  sort_by_cost(runs, kRuns);
  for (auto& [cost, at] : runs) {
    iterations += descend(residuals, bounds, 1, 60, 1e-5, at);
    cost = cost_of(residuals, at);
  }
  sort_by_cost(runs, kRuns);
  return runs;
}

/// The same curves with one control point more: b'_j = j/(n+1) b_{j-1} + (1 - j/(n+1)) b_j.
std::vector<double> elevated(const std::vector<double>& points, std::size_t degree) {
  const std::size_t old_points = degree + 1;
  std::vector<double> result;
  for (std::size_t first = 0; first < points.size(); first += old_points)
    for (std::size_t j = 0; j <= old_points; ++j) {
      const double share = static_cast<double>(j) / static_cast<double>(old_points);
      const double before = j > 0 ? points[first + j - 1] : 0.0;
      const double here = j < old_points ? points[first + j] : 0.0;
      result.push_back(share * before + (1.0 - share) * here);
    }
  return result;
}

}  // namespace

std::vector<double> FormulaCurves::at(double along) const {
  std::vector<double> basis(degree + 1);
  bernstein_basis(along, basis);
  std::vector<double> coefficients(points.size() / basis.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    coefficients[i / basis.size()] += basis[i % basis.size()] * points[i];
  return coefficients;
}

FormulaCurves better_of(const SkyFormula& formula, std::span<const FormulaSample> samples,
                        const FormulaCurves& known, const FormulaCurves& start) {
  const CurveResiduals residuals(formula, samples, start.degree);
  FormulaCurves found = start;
  found.iterations = known.iterations +
                     descend(residuals, formula.bounds(), start.degree + 1, kLastSteps, 1e-7, found.points);
  found.rms = rms_of(cost_of(residuals, found.points), samples.size());
  return found.rms < known.rms ? found : known;
}

FormulaCurves fit_formula(const SkyFormula& formula, std::span<const FormulaSample> samples,
                          std::size_t degree, const FormulaCurves* near) {
  FormulaCurves curves;
  curves.degree = degree;
  const std::vector<CoefficientBounds> bounds = formula.bounds();
  std::vector<Costed> runs = constant_fits(formula, samples, curves.iterations);
  const auto go_on = [&](Costed& run, std::size_t reached) {
    const bool last = reached == degree;
    const CurveResiduals residuals(formula, samples, reached);
    curves.iterations +=
        descend(residuals, bounds, reached + 1, last ? kLastSteps : kSteps, last ? 1e-7 : 1e-4, run.second);
    run.first = cost_of(residuals, run.second);
  };
  // The best constants need not lead to the best curves.
  sort_by_cost(runs, near == nullptr ? 4 : 2);
  for (std::size_t reached = 0; reached <= degree; ++reached) {
    for (Costed& run : runs) {
      if (reached > 0) run.second = elevated(run.second, reached - 1);
      go_on(run, reached);
    }
    if (reached == 3) sort_by_cost(runs, near == nullptr ? 2 : 1);
  }
  sort_by_cost(runs, 1);
  if (near != nullptr) {
    constexpr double kAsGood = 1.1;  // in cost: 5 % of the residuals
    Costed beside{0.0, near->points};
    go_on(beside, degree);
    if (beside.first <= kAsGood * runs.front().first) runs.front() = std::move(beside);
  }
  curves.points = std::move(runs.front().second);
  curves.rms = rms_of(runs.front().first, samples.size());
  return curves;
}

}  // namespace skylut::forms_detail
