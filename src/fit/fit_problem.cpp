#include "fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::fit_detail {

namespace {

// Angles are rounded to 2^-40 rad (1e-12): the two halves of a mirror-symmetric sky, or the skies of
// mirror-symmetric suns, then hold equal angles although their azimuths round differently.
double rounded_angle(double angle_rad) { return std::ldexp(std::round(std::ldexp(angle_rad, 40)), -40); }

// The zenith angle from which on the horizon's limit holds, as perez() has it: cosθ <= 1e-12.
double secant_excess(double zenith_rad) {
  constexpr double kHorizon = 1e-12;
  const double cos_zenith = std::cos(zenith_rad);
  return cos_zenith > kHorizon ? 1.0 / cos_zenith - 1.0 : std::numeric_limits<double>::infinity();
}

void check(const SkySample& sample, std::size_t index, ResidualKind residual) {
  if (!std::isfinite(sample.value))
    throw InputError("sky sample {}: value {}: must be a finite number", index, sample.value);
  if (residual == ResidualKind::relative && !(sample.value > 0.0))
    throw InputError("sky sample {}: value {}: must be greater than 0 for relative residuals", index,
                     sample.value);
  // Half a microradian beyond: 90° and 180° converted to radians.
  if (!(sample.zenith_rad >= 0.0 && sample.zenith_rad <= 0.5 * kPi + 5e-7))
    throw InputError("sky sample {}: zenith angle {}°: must lie within 0-90°", index,
                     sample.zenith_rad * kDegreesPerRadian);
  if (!(sample.gamma_rad >= 0.0 && sample.gamma_rad <= kPi + 5e-7))
    throw InputError("sky sample {}: angle to the sun {}°: must lie within 0-180°", index,
                     sample.gamma_rad * kDegreesPerRadian);
  if (!(sample.weight >= 0.0) || !std::isfinite(sample.weight))
    throw InputError("sky sample {}: weight {}: must be 0 or more", index, sample.weight);
}

}  // namespace

FitProblem make_fit_problem(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                            ResidualKind residual) {
  if (!(sun_zenith_rad >= 0.0 && sun_zenith_rad <= kPi))
    throw InputError("sun zenith angle {}°: must lie within 0-180°", sun_zenith_rad * kDegreesPerRadian);
  if (!std::isfinite(zenith_value) || zenith_value == 0.0)
    throw InputError("zenith value {}: must be a finite number other than 0", zenith_value);

  std::vector<SkySample> sorted;
  double weight_sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    check(samples[i], i, residual);
    if (samples[i].weight == 0.0) continue;
    sorted.push_back(samples[i]);
    sorted.back().zenith_rad = rounded_angle(samples[i].zenith_rad);
    sorted.back().gamma_rad = rounded_angle(samples[i].gamma_rad);
  }
  const auto key = [](const SkySample& s) { return std::tie(s.zenith_rad, s.gamma_rad, s.value, s.weight); };
  std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  for (const SkySample& sample : sorted) weight_sum += sample.weight;

  FitProblem problem;
  problem.samples = sorted.size();
  std::size_t directions = 0;
  double gamma_0 = kPi;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    gamma_0 = std::min(gamma_0, sorted[i].gamma_rad);
    if (i == 0 || sorted[i].zenith_rad != sorted[i - 1].zenith_rad ||
        sorted[i].gamma_rad != sorted[i - 1].gamma_rad)
      ++directions;
  }
  if (directions < 6)
    throw InputError("{} different sky directions: five coefficients need at least 6", directions);

  const double sun_zenith = rounded_angle(sun_zenith_rad);
  problem.sun = {sun_zenith, std::cos(sun_zenith) * std::cos(sun_zenith), gamma_0};
  for (std::size_t i = 0; i < sorted.size();) {
    const SkySample& sample = sorted[i];
    double weight = 0.0;
    for (; i < sorted.size() && sorted[i].zenith_rad == sample.zenith_rad &&
           sorted[i].gamma_rad == sample.gamma_rad && sorted[i].value == sample.value;
         ++i)
      weight += sorted[i].weight;
    const double scale = std::sqrt(weight * static_cast<double>(sorted.size()) / weight_sum) /
                         (residual == ResidualKind::relative ? sample.value : 1.0);
    const double cos_gamma = std::cos(sample.gamma_rad);
    const double excess = secant_excess(sample.zenith_rad);
    if (problem.observations.empty() || problem.observations.back().secant_excess != excess)
      problem.ring_begins.push_back(problem.observations.size());
    problem.observations.push_back({.secant_excess = excess,
                                    .gamma_rad = sample.gamma_rad,
                                    .cos2_excess = cos_gamma * cos_gamma - problem.sun.cos2_sun_zenith,
                                    .model_scale = scale * zenith_value,
                                    .target = scale * sample.value});
  }
  problem.ring_begins.push_back(problem.observations.size());
  constexpr double kSameAngle_rad = 1e-6;
  for (std::size_t i = 1; i < problem.observations.size(); ++i) {
    const Observation& one = problem.observations[i - 1];
    const Observation& next = problem.observations[i];
    if (one.secant_excess == next.secant_excess && next.gamma_rad - one.gamma_rad > kSameAngle_rad)
      problem.separable = true;
  }
  return problem;
}

}  // namespace skylut::fit_detail
