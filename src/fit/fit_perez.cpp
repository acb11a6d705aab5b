#include "skylut/fit/fit_perez.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include "fit_problem.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/preetham_coefficients.hpp"
#include "valley_search.hpp"

namespace skylut {

namespace {

using fit_detail::FitProblem;
using fit_detail::LinearParameters;
using fit_detail::Observation;

// Ceres reports numerical trouble through glog, to standard error unless told otherwise; the fit reports it
// through FitReport.
void silence_ceres() {
  static std::once_flag once;
  std::call_once(once, [] { FLAGS_minloglevel = google::GLOG_FATAL; });
}

// The residuals in the linear form, h (1 + aU) (1 + cW + eK) - t. [fit.md F3]
struct Residuals {
  const FitProblem* problem;

  template <class T>
  bool operator()(const T* parameter, T* residual) const {
    const T& a = parameter[0];
    const T& B = parameter[1];
    const T& c = parameter[2];
    const T& D = parameter[3];
    const T& e = parameter[4];
    for (std::size_t i = 0; i < problem->observations.size(); ++i) {
      const Observation& o = problem->observations[i];
      residual[i] =
          o.model_scale * (1.0 + a * fit_detail::gradation_basis(B, o.secant_excess)) *
              (1.0 + c * fit_detail::aureole_basis(D, o.gamma_rad, problem->sun) + e * o.cos2_excess) -
          o.target;
    }
    return true;
  }
};

// The same with c and e eliminated: for given a, B, D they follow by linear least squares. Since the
// elimination is differentiated along with the rest, the derivatives are those of the whole (variable
// projection, Golub and Pereyra 1973), and Levenberg-Marquardt is spared the curved valleys along which c, e
// and D trade. [fit.md F5]
struct ProjectedResiduals {
  const FitProblem* problem;

  // Parameters a, B, D.
  template <class T>
  bool operator()(const T* parameter, T* residual) const {
    T c, e;
    eliminate(parameter, residual, c, e);
    return true;
  }

  template <class T>
  void eliminate(const T* parameter, T* residual, T& c, T& e) const {
    const T& a = parameter[0];
    const T& B = parameter[1];
    const T& D = parameter[2];
    const std::size_t n = problem->observations.size();
    std::vector<T> aureole(n);
    std::vector<T> backward(n);
    // Samples are sorted by zenith angle: the gradation changes only from ring to ring.
    double ring = -1.0;
    T gradation(1.0);
    T KK(0.0), KW(0.0), KR(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const Observation& o = problem->observations[i];
      if (o.secant_excess != ring) {
        ring = o.secant_excess;
        gradation = 1.0 + a * fit_detail::gradation_basis(B, ring);
      }
      const T level = o.model_scale * gradation;
      residual[i] = level - o.target;
      aureole[i] = level * fit_detail::aureole_basis(D, o.gamma_rad, problem->sun);
      backward[i] = level * o.cos2_excess;
      KK += backward[i] * backward[i];
      KW += backward[i] * aureole[i];
      KR += backward[i] * residual[i];
    }
    // Gram-Schmidt: W made orthogonal to K, then the residual to both.
    const bool has_backward = KK > 0.0;
    const T share = has_backward ? T(KW / KK) : T(0.0);
    const T first_e = has_backward ? T(-KR / KK) : T(0.0);
    T before(0.0), WW(0.0), WR(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      before += aureole[i] * aureole[i];
      aureole[i] -= share * backward[i];
      residual[i] += first_e * backward[i];
      WW += aureole[i] * aureole[i];
      WR += aureole[i] * residual[i];
    }
    // A column that is dependent to 12 digits is left out.
    const bool has_aureole = WW > 1e-24 * before;
    c = has_aureole ? T(-WR / WW) : T(0.0);
    e = first_e - c * share;
    for (std::size_t i = 0; i < n; ++i) residual[i] += c * aureole[i];
  }
};

struct Polished {
  double cost = std::numeric_limits<double>::infinity();
  LinearParameters parameters{};
  Termination termination = Termination::not_run;
  std::string message;
  int iterations = 0;
};

// Levenberg-Marquardt on one set of residuals, from any start.
class Polisher {
 public:
  Polisher(const FitProblem& problem, const FitOptions& options)
      : options_(options),
        residuals_{&problem},
        cost_(new ProjectedResiduals{&problem}, static_cast<int>(problem.observations.size())),
        problem_(ceres_options()) {
    problem_.AddResidualBlock(&cost_, nullptr, at_.data());
    problem_.SetParameterLowerBound(at_.data(), 1, options.B_lower);
    problem_.SetParameterUpperBound(at_.data(), 1, options.B_upper);
    problem_.SetParameterLowerBound(at_.data(), 2, options.D_lower);
    problem_.SetParameterUpperBound(at_.data(), 2, options.D_upper);
  }

  Polished run(const LinearParameters& start, double tolerance, int max_iterations) {
    at_ = {start[0], std::clamp(start[1], options_.B_lower, options_.B_upper),
           std::clamp(start[3], options_.D_lower, options_.D_upper)};
    ceres::Solver::Options solver;
    solver.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    solver.max_num_iterations = max_iterations;
    solver.function_tolerance = tolerance;
    solver.parameter_tolerance = 1e-13;
    solver.gradient_tolerance = 1e-15;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    // At a bound Ceres cuts every step short: go on along the bound.
    std::vector<int> bound;
    if (at_[1] <= options_.B_lower || at_[1] >= options_.B_upper) bound.push_back(1);
    if (at_[2] <= options_.D_lower || at_[2] >= options_.D_upper) bound.push_back(2);
    if (!bound.empty()) {
      problem_.SetManifold(at_.data(), new ceres::SubsetManifold(3, bound));
      ceres::Solve(solver, &problem_, &summary);
      problem_.SetManifold(at_.data(), nullptr);
    }
    Polished result;
    if (!summary.IsSolutionUsable()) return result;
    std::vector<double> residual(static_cast<std::size_t>(cost_.num_residuals()));
    double c = 0.0;
    double e = 0.0;
    residuals_.eliminate(at_.data(), residual.data(), c, e);
    result.cost = summary.final_cost;
    result.parameters = {at_[0], at_[1], c, at_[2], e};
    result.termination =
        summary.termination_type == ceres::CONVERGENCE ? Termination::converged : Termination::no_convergence;
    result.message = summary.message;
    result.iterations = static_cast<int>(summary.iterations.size()) - 1;
    return result;
  }

 private:
  static ceres::Problem::Options ceres_options() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  const FitOptions& options_;
  ProjectedResiduals residuals_;
  std::array<double, 3> at_{};  // a, B, D
  ceres::AutoDiffCostFunction<ProjectedResiduals, ceres::DYNAMIC, 3> cost_;
  ceres::Problem problem_;
};

// Derivatives of the residuals by a, B, c, D, e, observations × 5.
Eigen::MatrixXd residual_derivatives(const FitProblem& problem, const LinearParameters& at) {
  const int count = static_cast<int>(problem.observations.size());
  const ceres::AutoDiffCostFunction<Residuals, ceres::DYNAMIC, 5> function(new Residuals{&problem}, count);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(count, 5);
  std::vector<double> residual(problem.observations.size());
  const double* blocks[] = {at.data()};
  double* derivatives[] = {rows.data()};
  function.Evaluate(blocks, residual.data(), derivatives);
  return rows;
}

// d(A…E)/d(a, B, c, D, e).
Eigen::Matrix<double, 5, 5> coefficient_derivatives(const LinearParameters& at,
                                                    const fit_detail::SunFrame& sun) {
  using Jet = ceres::Jet<double, 5>;
  std::array<Jet, 5> variable;
  for (int i = 0; i < 5; ++i) variable[static_cast<std::size_t>(i)] = Jet(at[static_cast<std::size_t>(i)], i);
  const std::array<Jet, 5> coefficient = fit_detail::to_perez(variable, sun);
  Eigen::Matrix<double, 5, 5> derivatives;
  for (int i = 0; i < 5; ++i) derivatives.row(i) = coefficient[static_cast<std::size_t>(i)].v.transpose();
  return derivatives;
}

// Standard errors and the flag of determinacy, from the singular values of the Jacobian. [fit.md F6]
void judge(FitReport& report, const FitProblem& problem, const LinearParameters& at) {
  const Eigen::MatrixXd jacobian = residual_derivatives(problem, at);
  const Eigen::Matrix<double, 5, 5> derivatives = coefficient_derivatives(at, problem.sun);
  // Columns to equal length first: the rank must not depend on the units of the parameters.
  Eigen::Matrix<double, 5, 1> length;
  for (int i = 0; i < 5; ++i) {
    const double norm = jacobian.col(i).norm();
    length(i) = norm > 0.0 ? norm : 1.0;
  }
  const Eigen::MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinV);
  const Eigen::Matrix<double, 5, 5> moves = derivatives * length.cwiseInverse().asDiagonal() * svd.matrixV();

  // A coefficient known to within this is known, however small it is.
  constexpr double kNegligible = 0.1;
  // Below this share of the largest singular value a direction moves no residual beyond rounding.
  constexpr double kRankTolerance = 1e-8;
  const std::array<double, 5> value = report.coefficients.values();
  // Copies of a sample (the mirror half, the ring around a sun at the zenith) tell nothing new: merged, they
  // count as one. Whatever the residuals, no sky is simulated or measured to better than 1e-4.
  constexpr double kDataAccuracy = 1e-4;
  const auto distinct = static_cast<double>(problem.observations.size());
  const double variance = 2.0 * report.cost / std::max(1.0, distinct - 5.0);
  double size_of_data = 0.0;
  for (const Observation& o : problem.observations) size_of_data += o.target * o.target;
  const double careful_variance = std::max(variance, kDataAccuracy * kDataAccuracy * size_of_data / distinct);
  for (int i = 0; i < 5; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const double size = std::max(std::abs(value[index]), kNegligible);
    double sum = 0.0;
    bool fixed = true;
    for (int k = 0; k < 5; ++k) {
      const double singular = svd.singularValues()(k);
      if (singular > kRankTolerance * svd.singularValues()(0))
        sum += moves(i, k) * moves(i, k) / (singular * singular);
      else if (std::abs(moves(i, k)) > 1e-6 * size * moves.col(k).cwiseAbs().maxCoeff())
        fixed = false;
    }
    report.standard_error[index] =
        fixed ? std::sqrt(variance * sum) : std::numeric_limits<double>::infinity();
    report.determined[index] = problem.tells_factors_apart && fixed && !report.at_bound[index] &&
                               std::sqrt(careful_variance * sum) <= size;
  }
}

void check(const FitOptions& options) {
  if (!(options.B_lower < options.B_upper && options.B_upper < 0.0 && options.B_lower >= -80.0))
    throw InputError("bounds of B {} to {}: must rise within -80 to below 0", options.B_lower,
                     options.B_upper);
  if (!(options.D_lower < options.D_upper && options.D_lower >= -500.0 && options.D_upper <= 25.0))
    throw InputError("bounds of D {} to {}: must rise within -500 to 25", options.D_lower, options.D_upper);
  if (options.polished_starts < 1)
    throw InputError("{} polished starts: must be at least 1", options.polished_starts);
  if (options.max_iterations < 1)
    throw InputError("{} iterations: must be at least 1", options.max_iterations);
}

double relative_model(const FitProblem& problem, const PerezCoefficients& k, const Observation& o) {
  const double cos_zenith = 1.0 / (1.0 + o.secant_excess);
  const double sun = problem.sun.sun_zenith_rad;
  return perez(k.A, k.B, k.C, k.D, k.E, cos_zenith, o.gamma_rad, std::cos(o.gamma_rad)) /
         perez(k.A, k.B, k.C, k.D, k.E, 1.0, sun, std::cos(sun));
}

double cost_of(const FitProblem& problem, const PerezCoefficients& k) {
  double sum = 0.0;
  for (const Observation& o : problem.observations) {
    const double residual = o.model_scale * relative_model(problem, k, o) - o.target;
    sum += residual * residual;
  }
  return 0.5 * sum;
}

}  // namespace

std::string_view to_string(Termination termination) {
  switch (termination) {
    case Termination::converged:
      return "converged";
    case Termination::no_convergence:
      return "no_convergence";
    case Termination::not_run:
      break;
  }
  return "not_run";
}

FitReport fit_perez(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                    const FitOptions& options) {
  silence_ceres();
  check(options);
  const FitProblem problem =
      fit_detail::make_fit_problem(samples, sun_zenith_rad, zenith_value, options.residual);

  std::vector<LinearParameters> starts;
  for (const fit_detail::Valley& valley : search_valleys(problem, options, options.polished_starts))
    starts.push_back(valley.start);
  const PerezYxy preetham = preetham1999_coefficients(3.0);
  for (const PerezCoefficients& k : {preetham.Y, preetham.x, preetham.y})
    starts.push_back(fit_detail::to_linear(k, problem.sun));

  // A short run from every start, a thorough one from the two best ends.
  constexpr double kRough = 1e-5;
  constexpr int kRoughIterations = 30;
  Polisher polisher(problem, options);
  std::vector<Polished> ends;
  for (const LinearParameters& start : starts) {
    Polished end = polisher.run(start, kRough, std::min(kRoughIterations, options.max_iterations));
    if (std::isfinite(end.cost)) ends.push_back(std::move(end));
  }
  std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  Polished best;
  for (std::size_t i = 0; i < std::min<std::size_t>(ends.size(), 2); ++i) {
    Polished end = polisher.run(ends[i].parameters, 1e-14, options.max_iterations);
    end.iterations += ends[i].iterations;
    if (end.cost < best.cost) best = std::move(end);
  }
  if (!std::isfinite(best.cost)) throw WorkError("Perez fit: no start led to a finite cost");

  FitReport report;
  const std::array<double, 5> k = fit_detail::to_perez(best.parameters, problem.sun);
  // Adding 0 turns -0 into 0.
  report.coefficients = {k[0] + 0.0, k[1], k[2] + 0.0, k[3], k[4] + 0.0};
  report.zenith_value = zenith_value;
  report.cost = cost_of(problem, report.coefficients);
  report.rmse = std::sqrt(2.0 * report.cost / static_cast<double>(problem.samples));
  report.termination = best.termination;
  report.message = best.message;
  report.iterations = best.iterations;
  report.at_bound[1] = k[1] == options.B_lower || k[1] == options.B_upper;
  report.at_bound[3] = k[3] == options.D_lower || k[3] == options.D_upper;
  judge(report, problem, best.parameters);

  double worst = -1.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].weight == 0.0) continue;
    const double model = zenith_value * perez_relative(report.coefficients, samples[i].zenith_rad,
                                                       samples[i].gamma_rad, sun_zenith_rad);
    const double residual =
        (model - samples[i].value) / (options.residual == ResidualKind::relative ? samples[i].value : 1.0);
    if (std::abs(residual) <= worst) continue;
    worst = std::abs(residual);
    report.worst_residual = residual;
    report.worst_direction = i;
  }
  return report;
}

double perez_cost(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                  ResidualKind residual, const PerezCoefficients& coefficients) {
  return cost_of(fit_detail::make_fit_problem(samples, sun_zenith_rad, zenith_value, residual), coefficients);
}

}  // namespace skylut
