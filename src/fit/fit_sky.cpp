#include "skylut/fit/fit_sky.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/fit/dome_directions.hpp"

namespace skylut {

namespace {

// The zenith sample; directions this close to the vertical are the zenith.
std::size_t zenith_index(std::span<const SkyDirection> views) {
  constexpr double kZenith_rad = 1e-6 * kRadiansPerDegree;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (std::abs(views[i].zenith_rad) <= kZenith_rad) return i;
  throw InputError("sky without a zenith direction: one of the {} directions must have zenith angle 0",
                   views.size());
}

void check(std::span<const SkyDirection> views, std::span<const Yxy> sky) {
  if (views.size() != sky.size())
    throw InputError("sky of {} directions and {} colours: there must be as many of both", views.size(),
                     sky.size());
  for (std::size_t i = 0; i < sky.size(); ++i) {
    if (!(sky[i].Y > 0.0) || !std::isfinite(sky[i].Y))
      throw InputError("sky direction {}: Y = {}: must be a number greater than 0", i, sky[i].Y);
    if (!std::isfinite(sky[i].x) || !std::isfinite(sky[i].y))
      throw InputError("sky direction {}: x = {}, y = {}: must be finite numbers", i, sky[i].x, sky[i].y);
  }
}

}  // namespace

std::vector<double> solid_angle_weights(std::span<const double> zenith_rad) {
  // Rings: directions of equal zenith angle, to 1e-9 rad.
  const auto ring_of = [](double zenith) { return std::llround(zenith * 1e9); };
  std::map<long long, double> count;
  for (const double zenith : zenith_rad) count[ring_of(zenith)] += 1.0;
  std::map<long long, double> share;
  double total = 0.0;
  for (auto ring = count.begin(); ring != count.end(); ++ring) {
    const auto middle = [](long long a, long long b) { return 0.5e-9 * static_cast<double>(a + b); };
    const double from = ring == count.begin() ? 0.0 : middle(std::prev(ring)->first, ring->first);
    const double to =
        std::next(ring) == count.end() ? 0.5 * kPi : middle(ring->first, std::next(ring)->first);
    share[ring->first] = (std::cos(from) - std::cos(to)) / ring->second;
    total += std::cos(from) - std::cos(to);
  }
  std::vector<double> weights;
  weights.reserve(zenith_rad.size());
  for (const double zenith : zenith_rad)
    weights.push_back(share[ring_of(zenith)] * static_cast<double>(zenith_rad.size()) / total);
  return weights;
}

std::vector<double> sample_weights(std::span<const double> zenith_rad,
                                   std::span<const double> solid_angles_sr, SampleWeights weights) {
  std::vector<double> found;
  if (weights == SampleWeights::uniform)
    found.assign(zenith_rad.size(), 1.0);
  else if (solid_angles_sr.empty())
    found = solid_angle_weights(zenith_rad);
  else
    found.assign(solid_angles_sr.begin(), solid_angles_sr.end());
  if (weights == SampleWeights::horizon)
    for (std::size_t i = 0; i < found.size(); ++i) found[i] *= horizon_emphasis(zenith_rad[i]);
  return found;
}

SkyFit fit_sky(std::span<const SkyDirection> views, std::span<const Yxy> sky, double sun_zenith_rad,
               const SkyFitOptions& options) {
  check(views, sky);
  const std::size_t zenith = zenith_index(views);
  std::vector<double> zenith_rad;
  for (const SkyDirection& view : views) zenith_rad.push_back(view.zenith_rad);
  const std::vector<double> weights = sample_weights(zenith_rad, {}, options.weights);

  const auto fit_channel = [&](double Yxy::*channel, ResidualKind residual) {
    std::vector<SkySample> samples;
    samples.reserve(views.size());
    for (std::size_t i = 0; i < views.size(); ++i)
      samples.push_back({views[i].zenith_rad, views[i].gamma_rad, sky[i].*channel, weights[i]});
    FitOptions fit = options.fit;
    fit.residual = residual;
    return fit_perez(samples, sun_zenith_rad, sky[zenith].*channel, fit);
  };
  return {.Y = fit_channel(&Yxy::Y, ResidualKind::relative),
          .x = fit_channel(&Yxy::x, ResidualKind::absolute),
          .y = fit_channel(&Yxy::y, ResidualKind::absolute),
          .zenith = sky[zenith]};
}

SkyFit fit_sky(std::span<const Direction> views, std::span<const Yxy> sky, const Direction& sun,
               const SkyFitOptions& options) {
  std::vector<SkyDirection> relative;
  relative.reserve(views.size());
  for (const Direction& view : views)
    relative.push_back({view.zenith_deg * kRadiansPerDegree, angle_between(view, sun)});
  return fit_sky(relative, sky, sun.zenith_deg * kRadiansPerDegree, options);
}

std::string unconverged_channels(const SkyFit& fit) {
  std::string names;
  for (const auto& [name, report] :
       {std::pair{"Y", &fit.Y}, std::pair{"x", &fit.x}, std::pair{"y", &fit.y}}) {
    if (report->termination == Termination::converged) continue;
    if (!names.empty()) names += ", ";
    names += name;
  }
  return names;
}

void require_converged(const SkyFit& fit) {
  if (const std::string channels = unconverged_channels(fit); !channels.empty())
    throw WorkError("the fit of {} did not converge: its coefficients are not those of a minimum", channels);
}

}  // namespace skylut
