#include "skylut/transfer/monte_carlo.hpp"

#include <bit>
#include <cmath>
#include <mutex>

#include "monte_carlo/first_collision.hpp"
#include "monte_carlo/photon_tracer.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"
#include "spherical/request_check.hpp"

namespace skylut {
namespace {

using namespace monte_carlo;

/// Batches per view: their scatter gives the standard error to about 1/√(2·63) = 9 %.
constexpr std::uint64_t kBatches = 64;
constexpr std::uint64_t kFewestPhotons = 2 * kBatches;
constexpr std::uint64_t kMostPhotons = 1'000'000'000'000;

void check(const Shells& shells, const OpticalColumn& column, const MonteCarloRequest& request,
           const MonteCarloOptions& options) {
  transfer::check_shells(shells);
  transfer::check_column(column, shells.levels_km.size() - 1);
  const double top = shells.levels_km.back();
  if (!(request.observer_altitude_km >= 0.0 && request.observer_altitude_km <= top))
    throw InputError("observer altitude {} km: must lie within the levels, 0-{}",
                     request.observer_altitude_km, top);
  if (!(request.sun_zenith_deg >= 0.0 && request.sun_zenith_deg <= 180.0))
    throw InputError("sun zenith angle {}: must lie within 0-180 degrees", request.sun_zenith_deg);
  for (const RelativeView& view : request.views)
    if (!(view.zenith_deg >= 0.0 && view.zenith_deg <= 180.0))
      throw InputError("view zenith angle {}: must lie within 0-180 degrees", view.zenith_deg);
  if (options.photons < kFewestPhotons || options.photons > kMostPhotons)
    throw InputError("photons {}: must lie within {}-{}", options.photons, kFewestPhotons, kMostPhotons);
  if (options.orders < 0) throw InputError("orders {}: must be >= 0 (0: all)", options.orders);
}

Vector unit_vector(double zenith_deg, double azimuth_deg) {
  const double zenith = zenith_deg * kRadiansPerDegree;
  const double azimuth = azimuth_deg * kRadiansPerDegree;
  return {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), std::cos(zenith)};
}

PhotonPosition observer_place(const Shells& shells, double altitude_km) {
  std::size_t layer = 0;
  while (layer + 2 < shells.levels_km.size() && altitude_km >= shells.levels_km[layer + 1]) ++layer;
  return {{0.0, 0.0, shells.planet_radius_km + altitude_km}, layer};
}

/// So that a view's numbers do not depend on which others are asked for.
std::uint64_t view_key(const RelativeView& view) {
  return std::bit_cast<std::uint64_t>(view.zenith_deg) * 31 +
         std::bit_cast<std::uint64_t>(view.relative_azimuth_deg);
}

struct Estimate {
  double mean = 0.0;
  double standard_error = 0.0;
};

/// Of one Stokes parameter of the view whose batches begin at `first`.
Estimate combine(const std::vector<Stokes>& batch_means, std::size_t first, std::size_t parameter) {
  Estimate combined;
  const auto count = static_cast<double>(kBatches);
  for (std::size_t b = 0; b < kBatches; ++b) combined.mean += batch_means[first + b][parameter] / count;
  double squares = 0.0;
  for (std::size_t b = 0; b < kBatches; ++b) {
    const double deviation = batch_means[first + b][parameter] - combined.mean;
    squares += deviation * deviation;
  }
  combined.standard_error = std::sqrt(squares / (count * (count - 1.0)));
  return combined;
}

}  // namespace

std::vector<MonteCarloRadiance> solve_monte_carlo(const Context& context, const Shells& shells,
                                                  const OpticalColumn& column,
                                                  const MonteCarloRequest& request,
                                                  const MonteCarloOptions& options) {
  check(shells, column, request, options);
  const Vector to_sun = unit_vector(request.sun_zenith_deg, 0.0);
  const PhotonTracer tracer(shells, column, to_sun, options.orders);
  const PhotonPosition observer = observer_place(shells, request.observer_altitude_km);
  std::vector<Vector> directions;
  std::vector<FirstCollision> collisions;
  for (const RelativeView& view : request.views) {
    directions.push_back(unit_vector(view.zenith_deg, view.relative_azimuth_deg));
    collisions.emplace_back(tracer.shells(), observer, directions.back(), to_sun);
  }

  const std::uint64_t per_batch = (options.photons + kBatches - 1) / kBatches;
  std::vector<Stokes> batch_means(request.views.size() * kBatches);
  std::mutex progress_lock;
  std::size_t done = 0;
  parallel_for(batch_means.size(), context.threads, [&](std::size_t task) {
    const std::size_t view = task / kBatches;
    const FirstCollision& collision = collisions[view];
    if (collision.empty()) return;
    RandomStream random(options.seed, view_key(request.views[view]), task % kBatches);
    Stokes sum{};
    for (std::uint64_t photon = 0; photon < per_batch; ++photon) {
      if (photon % 1024 == 0 && context.cancel.stop_requested()) throw Cancelled();
      // Stratified: one first collision in each equal share of the line of sight.
      const double choice = (static_cast<double>(photon) + random.uniform()) / static_cast<double>(per_batch);
      const FirstCollision::Draw first = collision.at(choice);
      if (options.polarised) {
        const StokesPath path(directions[view], request.views[view].relative_azimuth_deg);
        const Stokes found = tracer.trace(first, directions[view], path, random);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += found[i];
      } else {
        sum[0] += tracer.trace(first, directions[view], IntensityPath(directions[view]), random);
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
      batch_means[task][i] = sum[i] / static_cast<double>(per_batch);
    if (!context.progress) return;
    const std::scoped_lock lock(progress_lock);
    context.progress("tracing photons", ++done, batch_means.size());
  });

  std::vector<MonteCarloRadiance> radiance;
  for (std::size_t view = 0; view < request.views.size(); ++view) {
    const auto [i, i_error] = combine(batch_means, view * kBatches, 0);
    const auto [q, q_error] = combine(batch_means, view * kBatches, 1);
    const auto [u, u_error] = combine(batch_means, view * kBatches, 2);
    radiance.push_back({.radiance = i,
                        .standard_error = i_error,
                        .stokes_q = q,
                        .stokes_q_error = q_error,
                        .stokes_u = u,
                        .stokes_u_error = u_error,
                        .photons = per_batch * kBatches});
  }
  return radiance;
}

}  // namespace skylut
