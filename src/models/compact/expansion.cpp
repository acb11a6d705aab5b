#include "expansion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skylut/models/compact/coordinates.hpp"
#include "weighted_rows.hpp"

namespace skylut::compact {

namespace {

constexpr double kAltitude_km = 2.0;
constexpr double kLoad = 0.01;

template <class Coordinate>
std::vector<double> mapped(std::span<const double> nodes, const Coordinate& coordinate) {
  std::vector<double> values;
  for (const double node : nodes) values.push_back(coordinate(node));
  return values;
}

/// Multiplies one axis out: from [before][basis function][after] to [before][node][after].
std::vector<float> multiplied_out(const std::vector<float>& from, const Basis& basis, std::size_t after) {
  const std::size_t before = from.size() / (basis.columns * after);
  std::vector<float> to(before * basis.rows * after, 0.0f);
  for (std::size_t b = 0; b < before; ++b)
    for (std::size_t node = 0; node < basis.rows; ++node)
      for (std::size_t k = 0; k < basis.columns; ++k) {
        const float weight = basis.values[node * basis.columns + k];
        const float* in = from.data() + (b * basis.columns + k) * after;
        float* out = to.data() + (b * basis.rows + node) * after;
        for (std::size_t i = 0; i < after; ++i) out[i] += weight * in[i];
      }
  return to;
}

}  // namespace

double altitude_coordinate(double altitude_km) { return std::log1p(altitude_km / kAltitude_km); }

double load_coordinate(double aod500, double least) {
  return std::log(std::max(aod500 - least, 0.0) + kLoad);
}

Expansion::Expansion(Tables tables)
    : tables_(std::move(tables)),
      layout_(tables_.layout()),
      zenith_(tables_.zenith_counts, tables_.planet_radius_km),
      altitude_(mapped(tables_.nodes.altitudes_km, altitude_coordinate)),
      load_(mapped(std::span(tables_.nodes.aod500).subspan(1),
                   [this](double load) { return load_coordinate(load, tables_.nodes.aod500[1]); })),
      sun_(tables_.nodes.suns_deg) {
  for (std::size_t c = 0; c < layout_.channels(); ++c) {
    rayleigh_90_.push_back(static_cast<float>(tables_.rayleigh_90[c]));
    rayleigh_rise_.push_back(static_cast<float>(tables_.rayleigh_0[c] - tables_.rayleigh_90[c]));
  }
  // The ranks last: they are what a sky sums over.
  const std::size_t each = tables_.condition_core.size() / tables_.rank;
  std::vector<float> core(tables_.condition_core.size());
  for (std::size_t r = 0; r < tables_.rank; ++r)
    for (std::size_t i = 0; i < each; ++i) core[i * tables_.rank + r] = tables_.condition_core[r * each + i];
  core = multiplied_out(core, tables_.sun, tables_.rank);
  core = multiplied_out(core, tables_.altitude, tables_.sun.rows * tables_.rank);
  conditions_ = multiplied_out(core, tables_.load, tables_.altitude.rows * tables_.sun.rows * tables_.rank);
}

Expansion::LoadTaps Expansion::load_taps(double aod500) const {
  const double least = tables_.nodes.aod500[1];
  if (aod500 < least) return {0, {1.0 - aod500 / least, aod500 / least}};
  const SplineTaps taps = load_.taps(load_coordinate(aod500, least));
  return {taps.first + 1, {taps.weight, taps.weight + 4}};
}

std::vector<float> Expansion::features(double altitude_km, double aod500, double sun_zenith_deg) const {
  const LoadTaps load = load_taps(aod500);
  const SplineTaps altitude = altitude_.taps(altitude_coordinate(altitude_km));
  const SplineTaps sun = sun_.taps(sun_zenith_deg);
  const std::size_t rank = tables_.rank;
  std::vector<float> amplitude(rank, 0.0f);
  for (std::size_t l = 0; l < load.weight.size(); ++l)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t s = 0; s < 4; ++s) {
        const auto weight = static_cast<float>(load.weight[l] * altitude.weight[a] * sun.weight[s]);
        const float* node =
            conditions_.data() +
            (((load.first + l) * altitude_.size() + altitude.first + a) * sun_.size() + sun.first + s) * rank;
        for (std::size_t r = 0; r < rank; ++r) amplitude[r] += weight * node[r];
      }
  const std::size_t numbers = layout_.size();
  std::vector<float> functions(tables_.zenith.columns * numbers);
  weighted_rows(amplitude, tables_.feature_core.data(), functions);
  std::vector<float> features(tables_.zenith.rows * numbers);
  for (std::size_t node = 0; node < tables_.zenith.rows; ++node)
    weighted_rows(
        std::span(tables_.zenith.values).subspan(node * tables_.zenith.columns, tables_.zenith.columns),
        functions.data(), std::span(features).subspan(node * numbers, numbers));
  for (std::size_t i = 0; i < features.size(); ++i) features[i] += tables_.mean[i];
  return features;
}

std::vector<float> Expansion::ground_share(double aod500, double albedo, bool of_ground) const {
  const std::vector<double>& loads = tables_.nodes.aod500;
  const auto above =
      std::clamp<std::ptrdiff_t>(std::upper_bound(loads.begin(), loads.end(), aod500) - loads.begin(), 1,
                                 static_cast<std::ptrdiff_t>(loads.size()) - 1);
  const auto to = static_cast<std::size_t>(above);
  const double t = std::clamp((aod500 - loads[to - 1]) / (loads[to] - loads[to - 1]), 0.0, 1.0);
  const std::size_t channels = layout_.channels();
  const float* S_of = tables_.spherical_albedo.data() + (of_ground ? loads.size() * channels : 0);
  std::vector<float> share;
  for (std::size_t c = 0; c < channels; ++c) {
    const double S = (1.0 - t) * static_cast<double>(S_of[(to - 1) * channels + c]) +
                     t * static_cast<double>(S_of[to * channels + c]);
    share.push_back(static_cast<float>(albedo * (1.0 - S) / (1.0 - albedo * S)));
  }
  return share;
}

}  // namespace skylut::compact
