// The default table without its files: simulation and fits on one and two threads.

#include <benchmark/benchmark.h>

#include "skylut/table/fit_table.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

void default_table(benchmark::State& state) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0, 6.0, 12.0, 20.0, 30.0};
  for (const double aod500 : {0.0, 0.5, 1.0}) scene.turbidities.push_back({TurbidityKind::aod500, aod500});
  scene.suns = {{90.0, 90.0}, {45.0, 90.0}, {0.0, 0.0}, {45.0, 270.0}, {90.0, 270.0}};
  Context context = test::context;
  context.threads = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const TableSkies skies = simulate_table_skies(context, scene, {}, {});
    benchmark::DoNotOptimize(fit_table(context, skies.skies, TableFitOptions::half_floats()));
  }
}
BENCHMARK(default_table)
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skylut
