// The stages of the spherical solver on the default air: shared geometry, the diffuse field of one block of
// lanes, and lines of sight through it.

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "geometry/ray.hpp"
#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/profile/profile.hpp"
#include "skylut/transfer/plane_parallel.hpp"
#include "skylut/transfer/sky_radiance.hpp"
#include "spherical/block_optics.hpp"
#include "spherical/discretisation.hpp"
#include "spherical/kernel_choice.hpp"
#include "spherical/ray_sources.hpp"
#include "spherical/sweep_tables.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

using namespace transfer;

const Atmosphere& default_air() {
  static const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), AtmosphereOptions{});
  return air;
}

/// One full block of equal lanes at 550 nm; argument: aerosol optical depth at 500 nm in hundredths.
struct OneBlock {
  explicit OneBlock(benchmark::State& state)
      : column(default_air().column(550.0, 0.01 * static_cast<double>(state.range(0)))),
        common(default_air().shells(), discretisation_of(Quality::standard)),
        grid(common, discretisation_for(common.merge, common.discretisation, column)),
        tables(grid),
        lanes(static_cast<std::size_t>(kernel.lanes), &column),
        optics(grid, lanes, kernel.lanes, true) {
    state.SetLabel(kernel.name);
  }
  std::unique_ptr<SolvedBlock> solve() const {
    const IterationLimits limits{.scattering_orders = 0,
                                 .max_iterations = 200,
                                 .tolerance = static_cast<float>(common.discretisation.tolerance),
                                 .cancelled = nullptr,
                                 .token = nullptr};
    IterationReport report;
    return std::unique_ptr<SolvedBlock>(kernel.solve_block(tables.view(), optics.view(), limits, report));
  }

  Ray ray(const std::vector<SunAzimuth>& pairs) const {
    return {common.ray_space(), 0.0, 80.0, pairs, grid.angles.azimuthal_orders()};
  }

  const Kernel& kernel = kernel_for(Simd::best);
  OpticalColumn column;
  CommonGrid common;
  Discretisation grid;
  SweepTables tables;
  std::vector<const OpticalColumn*> lanes;
  BlockOptics optics;
};

void shared_geometry(benchmark::State& state) {
  const OpticalColumn column = default_air().column(550.0, 0.01 * static_cast<double>(state.range(0)));
  for (auto _ : state) {
    const CommonGrid common(default_air().shells(), discretisation_of(Quality::standard));
    benchmark::DoNotOptimize(std::make_unique<Discretisation>(
        common, discretisation_for(common.merge, common.discretisation, column)));
  }
}
BENCHMARK(shared_geometry)->Arg(0)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);

void diffuse_field_of_a_block(benchmark::State& state) {
  const OneBlock block(state);
  for (auto _ : state) benchmark::DoNotOptimize(block.solve());
}
BENCHMARK(diffuse_field_of_a_block)->Arg(0)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);

std::vector<SunAzimuth> ring_under_low_sun() {
  std::vector<SunAzimuth> pairs;
  for (int azimuth = 6; azimuth < 180; azimuth += 12) pairs.push_back({88.0, static_cast<double>(azimuth)});
  return pairs;
}

void ray_geometry_of_a_ring(benchmark::State& state) {
  const OneBlock block(state);
  const std::vector<SunAzimuth> pairs = ring_under_low_sun();
  for (auto _ : state) {
    Ray ray = block.ray(pairs);
    benchmark::DoNotOptimize(RaySources(block.grid, ray));
  }
}
BENCHMARK(ray_geometry_of_a_ring)->Arg(50)->Unit(benchmark::kMicrosecond);

void lines_of_sight_of_a_ring(benchmark::State& state) {
  const OneBlock block(state);
  const auto field = block.solve();
  const std::vector<SunAzimuth> pairs = ring_under_low_sun();
  Ray ray = block.ray(pairs);
  const RaySources sources(block.grid, ray);
  const std::vector<float> phase = block.optics.phases(ray);
  const std::vector<float> peaks = block.optics.peaks(ray);
  std::vector<float> radiance(pairs.size() * block.lanes.size());
  for (auto _ : state) {
    field->line_of_sight(ray.view(), sources.view(), phase.data(), peaks.data(), radiance.data());
    benchmark::DoNotOptimize(radiance.data());
  }
}
BENCHMARK(lines_of_sight_of_a_ring)->Arg(0)->Arg(50)->Unit(benchmark::kMicrosecond);

/// Transfer of the default table; arguments: altitudes, suns.
void whole_transfer(benchmark::State& state) {
  std::vector<OpticalColumn> columns;
  for (const double aod500 : {0.0, 0.5, 1.0})
    for (double wavelength_nm = 380.0; wavelength_nm <= 780.0; wavelength_nm += 5.0)
      columns.push_back(default_air().column(wavelength_nm, aod500));
  SkyRequest request;
  const auto altitudes = static_cast<double>(state.range(0));
  const auto suns = static_cast<double>(state.range(1));
  for (double i = 0.0; i < altitudes; ++i)
    request.observer_altitudes_km.push_back(30.0 * i / (altitudes - 1.0));
  for (double i = 0.0; i < suns; ++i) request.sun_zeniths_deg.push_back(90.0 * i / (suns - 1.0));
  request.views.push_back({0.0, 0.0});
  for (int ring = 1; ring <= 9; ++ring)
    for (int azimuth = 6; azimuth < 180; azimuth += 12)
      request.views.push_back({10.0 * ring, static_cast<double>(azimuth)});
  TransferOptions options;
  Context context;
  context.threads = 1;
  for (auto _ : state)
    benchmark::DoNotOptimize(solve_sky_radiance(context, default_air().shells(), columns, request, options));
}
BENCHMARK(whole_transfer)
    ->Args({5, 3})
    ->Args({5, 5})
    ->Args({20, 20})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void plane_parallel_solver(benchmark::State& state) {
  const OpticalColumn column = default_air().column(550.0, 0.01 * static_cast<double>(state.range(0)));
  PlaneParallelRequest request;
  request.cos_sun_zenith = 0.5;
  double depth = 0.0;
  for (const double layer : column.extinction_depth) depth += layer;
  request.output_depths = {depth};
  request.directions = PlaneParallelRequest::every({-1.0, -0.5, -0.1}, {0.0, 1.5, 3.0});
  for (auto _ : state) benchmark::DoNotOptimize(solve_plane_parallel(column, request));
}
BENCHMARK(plane_parallel_solver)->Arg(0)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skylut
