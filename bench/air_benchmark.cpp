// From a profile to the solver's lanes: loading the default profile, and one optical column.

#include <benchmark/benchmark.h>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/profile/profile.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

void load_default_profile(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(load_profile(test::context, "ussa1976"));
}
BENCHMARK(load_default_profile)->Unit(benchmark::kMicrosecond);

void build_air(benchmark::State& state) {
  const Profile profile = load_profile(test::context, "ussa1976");
  for (auto _ : state) benchmark::DoNotOptimize(Atmosphere(test::context, profile, AtmosphereOptions{}));
}
BENCHMARK(build_air)->Unit(benchmark::kMicrosecond);

void optical_column(benchmark::State& state) {
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), AtmosphereOptions{});
  for (auto _ : state) benchmark::DoNotOptimize(air.column(550.0, 0.5));
}
BENCHMARK(optical_column)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace skylut
