// What fitted models cost: a sky from conditions, and a direction of it.

#include <benchmark/benchmark.h>

#include <cmath>

#include "skylut/models/compact/tables.hpp"
#include "skylut/models/compact_sky.hpp"
#include "skylut/models/hosek_wilkie_model.hpp"
#include "skylut/models/perez_rows_model.hpp"
#include "skylut/models/preetham1999.hpp"
#include "skylut/models/preetham_model.hpp"

namespace skylut {
namespace {

ModelInfo everywhere() {
  ModelInfo info;
  info.altitude_km = {0.0, 30.0, "km"};
  info.turbidity = {0.0, 1.0, ""};
  info.albedo = Range{0.0, 1.0, ""};
  info.sun_zenith_deg = {0.0, 90.0, "deg"};
  info.view_zenith_deg = {0.0, 90.0, "deg"};
  return info;
}

SkyChannels channels_of(bool bands) {
  if (!bands) return {};
  return {.kind = SkyChannels::Kind::bands,
          .wavelengths = WavelengthGrid(380.0, 780.0, 40.0),
          .colour_weights = std::vector<Xyz>(11, {1.0, 1.0, 1.0})};
}

std::unique_ptr<const SkyModel> perez(bool bands) {
  const SkyChannels channels = channels_of(bands);
  std::vector<PerezRow> rows;
  for (const double altitude_km : {0.0, 10.0})
    for (const double turbidity : {0.1, 0.3})
      for (const double sun_deg : {30.0, 60.0})
        rows.push_back({altitude_km, turbidity, sun_deg,
                        std::vector<PerezCoefficients>(channels.size(), {-1.0, -0.3, 4.0, -2.0, 0.2}),
                        std::vector<double>(channels.size(), 0.3)});
  return std::make_unique<const PerezRowsModel>(everywhere(), channels, rows);
}

std::unique_ptr<const SkyModel> hosek_wilkie(bool bands) {
  HosekWilkieGrid grid{.altitudes_km = {0.0},
                       .turbidities = {0.1, 0.3},
                       .albedos = {0.0, 1.0},
                       .channels = channels_of(bands),
                       .curves = {}};
  if (!bands) grid.channels.kind = SkyChannels::Kind::Xyz;
  HosekWilkieCurves curves;
  constexpr HosekWilkieCoefficients kTypical{-1.1, -0.3, 0.6, 1.4, -2.5, 0.2, 0.15, 0.7, 0.4};
  for (std::size_t i = 0; i < kTypical.size(); ++i) curves.coefficients[i].fill(kTypical[i]);
  curves.mean.fill(1.0);
  grid.curves.assign(4 * grid.channels.size(), curves);
  return std::make_unique<const HosekWilkieModel>(everywhere(), std::move(grid));
}

std::unique_ptr<const SkyModel> preetham() {
  ModelInfo info = everywhere();
  info.turbidity_kind = TurbidityKind::preetham_t;
  info.turbidity = {2.0, 6.0, ""};
  return std::make_unique<const PreethamModel>(info,
                                               std::vector<PreethamLevel>{{0.0, preetham1999_matrices()}});
}

/// As large as the default's, of small numbers: what it is a table of does not matter here.
std::unique_ptr<const SkyModel> compact_sky() {
  compact::Tables tables;
  tables.nodes = {{}, {0.0, 0.005, 0.0115, 0.0225, 0.041, 0.071, 0.12, 0.2, 0.33, 0.52, 0.75, 1.0}, {}};
  for (int i = 0; i < 17; ++i) tables.nodes.altitudes_km.push_back(30.0 * i / 16.0);
  for (int i = 0; i < 27; ++i) tables.nodes.suns_deg.push_back(96.0 * i / 26.0);
  tables.planet_radius_km = 6371.0;
  tables.zenith_counts = {14, 12, 6};
  tables.channels = {"X", "Y", "Z"};
  tables.terms = 5;
  tables.haze_terms.assign(5 * 1024, 1.0f);
  tables.haze_mean = 1.0;
  tables.rayleigh_0.assign(3, 1.5);
  tables.rayleigh_90.assign(3, 0.75);
  tables.spherical_albedo.assign(2 * 3 * 12, 0.1f);
  const auto basis = [](std::size_t rows, std::size_t columns) {
    return compact::Basis{rows, columns, std::vector<float>(rows * columns, 0.1f)};
  };
  tables.load = basis(12, 11);
  tables.altitude = basis(17, 16);
  tables.sun = basis(27, 21);
  tables.zenith = basis(32, 22);
  tables.rank = 160;
  tables.condition_core.assign(160 * 11 * 16 * 21, 1e-3f);
  tables.feature_core.assign(160 * 22 * tables.layout().size(), 1e-3f);
  tables.mean.assign(32 * tables.layout().size(), 0.1f);
  ModelInfo info = everywhere();
  info.sun_zenith_deg = {0.0, 96.0, "deg"};
  info.view_zenith_deg = {0.0, 180.0, "deg"};
  return std::make_unique<const CompactSkyModel>(info, std::move(tables));
}

SkyConditions conditions(const SkyModel& model) {
  const bool T = model.info().turbidity_kind == TurbidityKind::preetham_t;
  return {0.0, {model.info().turbidity_kind, T ? 3.0 : 0.15}, 0.2, {40.0, 0.0}};
}

void sky_of_a_sun(benchmark::State& state, const std::unique_ptr<const SkyModel>& model) {
  const SkyConditions at = conditions(*model);
  for (auto _ : state) benchmark::DoNotOptimize(model->at(at));
}

void colour_of_a_direction(benchmark::State& state, const std::unique_ptr<const SkyModel>& model) {
  const std::unique_ptr<const Sky> sky = model->at(conditions(*model));
  std::vector<Direction> views;
  for (int i = 0; i < 1024; ++i) views.push_back({5.0 + 0.08 * i, std::fmod(0.7 * i, 360.0)});
  std::vector<Yxy> colours(views.size());
  for (auto _ : state) {
    sky->colour(views, colours);
    benchmark::DoNotOptimize(colours.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(views.size()));
}

// The conditions stand between two loads and two suns (two albedos): four rows or nodes are blended.
const std::unique_ptr<const SkyModel> kPerez = perez(false);
const std::unique_ptr<const SkyModel> kPerezSpectral = perez(true);
const std::unique_ptr<const SkyModel> kPreetham = preetham();
const std::unique_ptr<const SkyModel> kHosekWilkie = hosek_wilkie(false);
const std::unique_ptr<const SkyModel> kHosekWilkieSpectral = hosek_wilkie(true);
const std::unique_ptr<const SkyModel> kCompact = compact_sky();

BENCHMARK_CAPTURE(sky_of_a_sun, perez_of_4_rows, kPerez);
BENCHMARK_CAPTURE(sky_of_a_sun, perez_spectral_of_4_rows, kPerezSpectral);
BENCHMARK_CAPTURE(sky_of_a_sun, preetham, kPreetham);
BENCHMARK_CAPTURE(sky_of_a_sun, hosek_wilkie_of_4_nodes, kHosekWilkie);
BENCHMARK_CAPTURE(sky_of_a_sun, hosek_wilkie_spectral_of_4_nodes, kHosekWilkieSpectral);
BENCHMARK_CAPTURE(sky_of_a_sun, skylut, kCompact);
BENCHMARK_CAPTURE(colour_of_a_direction, skylut, kCompact);
BENCHMARK_CAPTURE(colour_of_a_direction, perez_of_4_rows, kPerez);
BENCHMARK_CAPTURE(colour_of_a_direction, perez_spectral_of_4_rows, kPerezSpectral);
BENCHMARK_CAPTURE(colour_of_a_direction, preetham, kPreetham);
BENCHMARK_CAPTURE(colour_of_a_direction, hosek_wilkie_of_4_nodes, kHosekWilkie);
BENCHMARK_CAPTURE(colour_of_a_direction, hosek_wilkie_spectral_of_4_nodes, kHosekWilkieSpectral);

}  // namespace
}  // namespace skylut
