#include "sun_bands.hpp"

#include <algorithm>
#include <iterator>

#include "common_grid.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/domain.hpp"

namespace skylut::transfer {

namespace {

/// Where a band ends, and how far beyond its suns it has nodes: as far as a horizontal ray goes while it
/// gathers most of its light (4° are 445 km, at whose end it is 15 km higher), less where the field hardly
/// changes on such a way, more in twilight, whose light comes from the day.
struct Band {
  double last_deg;
  double margin_deg;
};
constexpr double kDeepTwilight_deg = 96.0;
constexpr Band kBands[] = {{25.0, 1.0}, {52.0, 1.0}, {72.0, 1.0}, {82.0, 2.0},
                           {87.5, 3.5}, {91.0, 3.0}, {94.0, 6.0}, {kDeepTwilight_deg, 7.0}};
/// And as many nodes more as interpolation reaches to.
constexpr std::ptrdiff_t kNodesBelow = 1;
constexpr std::ptrdiff_t kNodesAbove = 2;

}  // namespace

std::vector<SunBand> sun_bands(const DiscretisationOptions& options) {
  const std::vector<double> all = sun_nodes(options.sun_node_density);
  // Deep twilight shares no fields with what is lighter: its nodes are its own.
  const SunBand deep{domain::kSunZenith_deg.highest, deep_twilight_nodes(options.sun_node_density)};
  SunBand outside{domain::kAnyZenith_deg.highest, all};
  while (outside.nodes_deg.back() > kDeepTwilight_deg) outside.nodes_deg.pop_back();
  std::copy_if(deep.nodes_deg.begin(), deep.nodes_deg.end(), std::back_inserter(outside.nodes_deg),
               [](double node) { return node > kDeepTwilight_deg; });
  if (!options.sun_bands) return {{kDeepTwilight_deg, all}, deep, outside};
  std::vector<SunBand> bands;
  double first_deg = 0.0;
  for (const auto& [last_deg, margin_deg] : kBands) {
    const auto begin = std::lower_bound(all.begin(), all.end(), first_deg - margin_deg);
    const auto end = std::upper_bound(all.begin(), all.end(), last_deg + margin_deg);
    bands.push_back(
        {last_deg,
         {begin - std::min(kNodesBelow, begin - all.begin()), end + std::min(kNodesAbove, all.end() - end)}});
    first_deg = last_deg;
  }
  bands.push_back(deep);
  bands.push_back(outside);
  return bands;
}

std::size_t band_of(std::span<const SunBand> bands, double sun_zenith_deg) {
  SKYLUT_CHECK_LE(sun_zenith_deg, bands.back().last_deg);
  std::size_t band = 0;
  while (sun_zenith_deg > bands[band].last_deg) ++band;
  return band;
}

}  // namespace skylut::transfer
