// One sky: solving its atmosphere, building it at an altitude, and what a direction costs then.

#include <benchmark/benchmark.h>

#include <cmath>

#include "skylut/atmosphere/atmosphere_description.hpp"
#include "skylut/sky/continuous_sky.hpp"
#include "skylut/sky/sky_scene.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

const Direction kSun{60.0, 180.0};

std::shared_ptr<const SolvedSky> solve() {
  SkyScene scene;
  scene.atmosphere = std::make_shared<const Atmosphere>(build_atmosphere(test::context, {}));
  scene.turbidities = {{TurbidityKind::aod500, 0.1}};
  scene.suns = {kSun, {92.0, 180.0}};
  return std::make_shared<const SolvedSky>(test::on_threads(1), scene, TransferOptions{});
}

const std::shared_ptr<const SolvedSky>& solved() {
  static const std::shared_ptr<const SolvedSky> one = solve();
  return one;
}

void solve_atmosphere(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(solve());
}
BENCHMARK(solve_atmosphere)->Unit(benchmark::kMillisecond);

void build_sky(benchmark::State& state) {
  const Direction sun{static_cast<double>(state.range(1)), 180.0};
  const std::shared_ptr<const SolvedSky> atmosphere = solved();
  for (auto _ : state) {
    const ContinuousSky sky(test::on_threads(1), atmosphere, static_cast<double>(state.range(0)), sun);
    state.counters["nodes"] = static_cast<double>(sky.nodes());
  }
}
BENCHMARK(build_sky)->Args({0, 60})->Args({12, 60})->Args({0, 92})->Args({12, 92})->Unit(
    benchmark::kMillisecond);

/// A ring of directions, whose neighbours share a zenith angle (of a latlong picture), or a spiral, whose do
/// not.
std::vector<Direction> directions(bool ring) {
  std::vector<Direction> all;
  for (int i = 0; i < 1024; ++i)
    all.push_back({ring ? 30.0 + i / 256 : 5.0 + 0.1 * i, std::fmod(0.7 * i, 360.0)});
  return all;
}

void colour_of_a_direction(benchmark::State& state) {
  const ContinuousSky sky(test::context, solved(), 0.0, kSun);
  const std::vector<Direction> views = directions(state.range(0) == 1);
  std::vector<Xyz> colours(views.size());
  for (auto _ : state) {
    sky.colour(views, colours);
    benchmark::DoNotOptimize(colours.data());
  }
  state.SetItemsProcessed(state.iterations() * 1024);
}
BENCHMARK(colour_of_a_direction)->Arg(1)->Arg(0);

void spectrum_of_a_direction(benchmark::State& state) {
  const ContinuousSky sky(test::context, solved(), 0.0, kSun);
  const std::vector<Direction> views = directions(state.range(0) == 1);
  std::vector<float> spectra(views.size() * sky.wavelengths().size());
  for (auto _ : state) {
    sky.radiance(views, spectra);
    benchmark::DoNotOptimize(spectra.data());
  }
  state.SetItemsProcessed(state.iterations() * 1024);
}
BENCHMARK(spectrum_of_a_direction)->Arg(1)->Arg(0);

}  // namespace
}  // namespace skylut
