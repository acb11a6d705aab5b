// The default table without its files: simulation and fits on one and two threads.

#include <benchmark/benchmark.h>

#include "skylut/models/preetham_coefficients.hpp"
#include "skylut/sky/simulate_sky.hpp"
#include "skylut/table/fit_table.hpp"
#include "skylut/table/table_model.hpp"
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

// A table of Preetham's coefficients on 5 altitudes × 3 loads × 4 suns: what interpolating costs does not
// depend on its size.
TableModel model_between_rows() {
  std::vector<TableEntry> rows;
  for (const double altitude_km : {0.0, 2.0, 6.0, 12.0, 20.0})
    for (const double turbidity : {0.0, 0.25, 1.0})
      for (const double sun_zenith_deg : {2.0, 30.0, 60.0, 90.0}) {
        const PerezYxy c = preetham1999_coefficients(2.0 + turbidity);
        TableEntry row;
        row.altitude_km = altitude_km;
        row.turbidity = turbidity;
        row.sun = {sun_zenith_deg, 0.0};
        row.Y = c.Y;
        row.x = c.x;
        row.y = c.y;
        row.zenith = {4.0, 0.25, 0.26};
        rows.push_back(row);
      }
  return TableModel(Table(rows));
}

constexpr SkyConditions kBetween{
    .altitude_km = 3.0, .turbidity = {TurbidityKind::aod500, 0.1}, .sun = {50.0, 130.0}};
constexpr SkyConditions kAtARow{
    .altitude_km = 2.0, .turbidity = {TurbidityKind::aod500, 0.25}, .sun = {60.0, 130.0}};

// One condition, between eight rows.
void table_sky(benchmark::State& state) {
  const TableModel model = model_between_rows();
  for (auto _ : state) benchmark::DoNotOptimize(model.at(kBetween));
}
BENCHMARK(table_sky)->Unit(benchmark::kMicrosecond);

// Directions of one sky; items are directions.
void table_directions(benchmark::State& state, const SkyConditions& conditions) {
  const auto sky = model_between_rows().at(conditions);
  const std::vector<Direction> views = directions_utm271();
  std::vector<Yxy> colours(views.size());
  for (auto _ : state) {
    sky->colour(views, colours);
    benchmark::DoNotOptimize(colours.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(views.size()));
}
BENCHMARK_CAPTURE(table_directions, between_rows, kBetween)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(table_directions, at_a_row, kAtARow)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace skylut
