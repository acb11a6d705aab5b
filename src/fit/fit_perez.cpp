#include "skylut/fit/fit_perez.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fit_problem.hpp"
#include "identifiability.hpp"
#include "local_search.hpp"
#include "multistart.hpp"
#include "perez_form.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {

namespace {

using fit_detail::FitProblem;
using fit_detail::LinearParameters;
using fit_detail::Observation;
using fit_detail::PerezForm;

// Whatever the residuals, no sky is simulated or measured to better than this share of its values.
constexpr double kDataAccuracy = 1e-4;

// Standard errors and flags. [fit.md F6]
void judge(FitReport& report, const FitProblem& problem, const PerezForm& form, const LinearParameters& at) {
  const std::array<double, 5> values = report.coefficients.values();
  // Copies of a sample (the mirror half, the ring around a sun at the zenith) tell nothing new: merged, they
  // count as one.
  const auto distinct = static_cast<double>(problem.observations.size());
  double size_of_data = 0.0;
  for (const Observation& o : problem.observations) size_of_data += o.target * o.target;
  fit_detail::FitAtMinimum fit;
  fit.jacobian = form.jacobian(at);
  fit.coefficient_derivatives = form.coefficient_derivatives(at);
  fit.coefficients.assign(values.begin(), values.end());
  fit.variance = 2.0 * report.cost / std::max(1.0, distinct - 5.0);
  fit.careful_variance = std::max(fit.variance, kDataAccuracy * kDataAccuracy * size_of_data / distinct);
  const std::vector<fit_detail::Identifiability> found = identifiability(fit);
  for (std::size_t i = 0; i < values.size(); ++i) {
    report.standard_error[i] = found[i].standard_error;
    report.determined[i] = problem.separable && found[i].determined && !report.at_bound[i];
  }
}

void check(const FitOptions& options) {
  if (!(options.B_lower < options.B_upper && options.B_upper < 0.0 && options.B_lower >= -80.0))
    throw InputError("bounds of B {} to {}: must rise within -80 to below 0", options.B_lower,
                     options.B_upper);
  if (!(options.D_lower < options.D_upper && options.D_lower >= -500.0 && options.D_upper <= 25.0))
    throw InputError("bounds of D {} to {}: must rise within -500 to 25", options.D_lower, options.D_upper);
  if (!(options.largest_gradation > 1.0 && options.largest_scattering > 1.0))
    throw InputError("largest gradation {} and scattering {}: must be above 1", options.largest_gradation,
                     options.largest_scattering);
  if (options.starts < 1) throw InputError("{} starts: must be at least 1", options.starts);
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

void find_worst(FitReport& report, std::span<const SkySample> samples, double sun_zenith_rad,
                ResidualKind kind) {
  double worst = -1.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].weight == 0.0) continue;
    const double model = report.zenith_value * perez_relative(report.coefficients, samples[i].zenith_rad,
                                                              samples[i].gamma_rad, sun_zenith_rad);
    const double residual =
        (model - samples[i].value) / (kind == ResidualKind::relative ? samples[i].value : 1.0);
    if (std::abs(residual) <= worst) continue;
    worst = std::abs(residual);
    report.worst_residual = residual;
    report.worst_direction = i;
  }
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

std::vector<PerezMinimum> perez_minima(std::span<const SkySample> samples, double sun_zenith_rad,
                                       double zenith_value, const FitOptions& options, double within) {
  check(options);
  const FitProblem problem =
      fit_detail::make_fit_problem(samples, sun_zenith_rad, zenith_value, options.residual);
  const PerezForm form(problem, options);
  fit_detail::LocalSearch search(problem, options);
  std::vector<PerezMinimum> minima;
  for (fit_detail::Minimum& end :
       fit_detail::multistart([&search](const fit_detail::Start&start, double tolerance,
                                        int iterations) { return search.run(start, tolerance, iterations); },
                              form.starts(), options.max_iterations, within)) {
    if (end.termination == Termination::no_convergence) end = form.search_on(std::move(end));
    const std::array<double, 5> k = fit_detail::to_perez(form.all_parameters(end.at), problem.sun);
    // Adding 0 turns -0 into 0.
    const PerezCoefficients coefficients{k[0] + 0.0, k[1], k[2] + 0.0, k[3], k[4] + 0.0};
    const double cost = cost_of(problem, coefficients);
    if (std::isfinite(cost))
      minima.push_back({coefficients, cost, end.termination, end.message, end.iterations});
  }
  if (minima.empty()) throw WorkError("Perez fit: no start led to a formula with a finite cost");
  std::stable_sort(minima.begin(), minima.end(),
                   [](const auto& one, const auto& other) { return one.cost < other.cost; });
  return minima;
}

FitReport perez_report(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                       const FitOptions& options, const PerezMinimum& minimum) {
  const FitProblem problem =
      fit_detail::make_fit_problem(samples, sun_zenith_rad, zenith_value, options.residual);
  FitReport report;
  report.coefficients = minimum.coefficients;
  report.zenith_value = zenith_value;
  report.cost = minimum.cost;
  report.rmse = std::sqrt(2.0 * report.cost / static_cast<double>(problem.samples));
  report.termination = minimum.termination;
  report.message = minimum.message;
  report.iterations = minimum.iterations;
  const PerezCoefficients& k = minimum.coefficients;
  report.at_bound[1] = k.B == options.B_lower || k.B == options.B_upper;
  report.at_bound[3] = k.D == options.D_lower || k.D == options.D_upper;
  judge(report, problem, PerezForm(problem, options), fit_detail::to_linear(k, problem.sun));
  find_worst(report, samples, sun_zenith_rad, options.residual);
  return report;
}

FitReport fit_perez(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                    const FitOptions& options) {
  return perez_report(samples, sun_zenith_rad, zenith_value, options,
                      perez_minima(samples, sun_zenith_rad, zenith_value, options, 0.0).front());
}

double perez_cost(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                  ResidualKind residual, const PerezCoefficients& coefficients) {
  return cost_of(fit_detail::make_fit_problem(samples, sun_zenith_rad, zenith_value, residual), coefficients);
}

}  // namespace skylut
