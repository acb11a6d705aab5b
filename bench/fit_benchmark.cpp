// Perez fits of one simulated sky: three channels, as a table fits them.

#include <benchmark/benchmark.h>

#include "skylut/table/fit_table.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

// Skies of one sun: three altitudes, haze in the air.
TableSkies skies_of(double sun_zenith_deg, const TableSampling& sampling) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0, 6.0, 12.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.5}};
  scene.suns = {{sun_zenith_deg, 90.0}};
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 20.0);
  return simulate_table_skies(test::context, scene, {}, sampling);
}

// Counts fits: channels of skies.
void fit_skies(benchmark::State& state, const TableSampling& sampling, TableFitOptions options) {
  const TableSkies skies = skies_of(static_cast<double>(state.range(0)), sampling);
  options.branch_tolerance = 0.0;
  Context context = test::context;
  context.threads = 1;
  for (auto _ : state) benchmark::DoNotOptimize(fit_table(context, skies.skies, options));
  state.counters["per_fit"] =
      benchmark::Counter(3.0 * static_cast<double>(skies.skies.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void dome(benchmark::State& state) { fit_skies(state, {}, TableFitOptions::half_floats()); }
BENCHMARK(dome)->Arg(0)->Arg(45)->Arg(87)->Arg(90)->Unit(benchmark::kMillisecond);

void utm271(benchmark::State& state) {
  TableSampling sampling;
  sampling.directions = directions_utm271();
  fit_skies(state, sampling, TableFitOptions::utm2005());
}
BENCHMARK(utm271)->Arg(0)->Arg(45)->Arg(87)->Arg(90)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skylut
