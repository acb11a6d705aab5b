// Perez fits of one simulated sky, all three channels.

#include <benchmark/benchmark.h>

#include "skylut/fit/fit_sky.hpp"
#include "skylut/sky/simulate_sky.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

void fit_one_sky(benchmark::State& state) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.5}};
  scene.suns = {{static_cast<double>(state.range(0)), 90.0}};
  scene.directions = directions_utm271();
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 20.0);
  const SkyMap map = simulate_sky(test::context, scene, {}).front();
  for (auto _ : state) benchmark::DoNotOptimize(fit_sky(map.directions, map.colour, map.sun, {}));
}
BENCHMARK(fit_one_sky)->Arg(0)->Arg(45)->Arg(90)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skylut
