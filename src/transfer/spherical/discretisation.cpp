#include "discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "skylut/core/constants.hpp"

namespace skylut::transfer {

namespace {

/// Thickness of the lowest sublayer: close to the ground the radiance of grazing directions changes over
/// tens of metres. Further sublayers double it until they meet the layer's own splitting.
constexpr double kLowestSublayer_km = 0.02;

/// Over the earth, thickness above which a sublayer of a medium that fills the column evenly bends the
/// light's path too much: a ray that grazes it is 280 km long, under suns that differ by 2.5°. On other
/// planets in proportion to the radius, which leaves the angles the same.
constexpr double kThickestSublayer_km = 1.5;
constexpr double kEarthRadius_km = 6371.0;
/// Share of the column's scattering below which a layer is not split for its thickness: layers of air are not
/// even, and thick only where little is left of it (2 km at 20 km hold 1.5 %, all above 30 km 1.2 %).
constexpr double kEvenShare = 0.019;

/// A layer that needs more parts than this is thick: only towards its two boundaries does the light in it
/// change over a free path. Further in, parts grow with the way to the nearer boundary, to twelve times the
/// finest (at the default quality a depth of 0.3), and again where hardly any light gets (beyond a depth of
/// 100).
constexpr int kMostEqualParts = 50;
constexpr double kGrowth = 0.05;
constexpr double kCoarsest = 8.0;
constexpr double kDeep = 2500.0;

/// A medium that ends abruptly at the top of the atmosphere, as air does not: a low sun's depth begins like
/// the square root of the way down. Where it is more than this in the uppermost sublayer, that is graded.
constexpr double kMostDepthAlongTop = 0.25;
constexpr double kUppermostSublayer_km = 0.1;

double layer_thickness(const Shells& shells, std::size_t layer) {
  return shells.levels_km[layer + 1] - shells.levels_km[layer];
}

double thickest_sublayer_km(const Shells& shells) {
  return kThickestSublayer_km * shells.planet_radius_km / kEarthRadius_km;
}

/// Heights above the bottom of a thick layer where its parts begin and end, without the layer's own two.
std::vector<double> graded_heights(double thickness_km, int parts, double thickest_km) {
  const double finest_km = thickness_km / parts;
  const double room = std::max(1.0, thickest_km / finest_km);
  std::vector<double> lower;
  double height = 1.0;  // in finest parts
  double step = 1.0;
  for (; height < 0.5 * parts; height += step) {
    lower.push_back(height * finest_km);
    const double coarsest = std::max(kCoarsest, kCoarsest + kGrowth * (height - kDeep));
    step = std::min(std::clamp(kGrowth * height, 1.0, coarsest), room);
  }
  // No part in the middle thinner than half of its neighbours.
  if (0.5 * thickness_km - lower.back() < 0.25 * step * finest_km) lower.pop_back();
  std::vector<double> heights = lower;
  for (auto below = lower.rbegin(); below != lower.rend(); ++below) heights.push_back(thickness_km - *below);
  return heights;
}

/// Adds a level at every doubling of a height above the level, as far as a step leaves room.
void add_graded(std::vector<double>& levels, double from_km, double first_km, double step_km, double side) {
  for (double height = first_km; height < 0.75 * step_km; height *= 2.0)
    levels.push_back(from_km + side * height);
}

std::vector<double> split_levels(const Shells& shells, const std::vector<int>& parts, bool grades_top) {
  std::vector<double> levels{shells.levels_km.front()};
  for (std::size_t layer = 0; layer < parts.size(); ++layer) {
    const double bottom = shells.levels_km[layer];
    const double step = layer_thickness(shells, layer) / parts[layer];
    if (layer == 0) add_graded(levels, bottom, kLowestSublayer_km, step, 1.0);
    if (grades_top && layer + 1 == parts.size())
      add_graded(levels, shells.levels_km.back(), kUppermostSublayer_km, step, -1.0);
    if (parts[layer] > kMostEqualParts) {
      for (const double height :
           graded_heights(layer_thickness(shells, layer), parts[layer], thickest_sublayer_km(shells)))
        levels.push_back(bottom + height);
      levels.push_back(shells.levels_km[layer + 1]);
      continue;
    }
    for (int part = 1; part <= parts[layer]; ++part)
      levels.push_back(part == parts[layer] ? shells.levels_km[layer + 1] : bottom + part * step);
  }
  std::sort(levels.begin(), levels.end());
  return levels;
}

std::vector<int> layers_of(const Shells& merged, const ShellGeometry& sublayers) {
  const ShellGeometry layers(merged.levels_km, merged.planet_radius_km);
  std::vector<int> layer_of;
  for (int sublayer = 0; sublayer < sublayers.layers(); ++sublayer)
    layer_of.push_back(
        layers.layer_of(0.5 * (sublayers.level_km(sublayer) + sublayers.level_km(sublayer + 1))));
  return layer_of;
}

std::vector<double> joined_levels(const ShellGeometry& layers, const ShellGeometry& sublayers) {
  std::vector<double> levels;
  std::set_union(layers.levels_km().begin(), layers.levels_km().end(), sublayers.levels_km().begin(),
                 sublayers.levels_km().end(), std::back_inserter(levels));
  return levels;
}

/// Parts of a layer beyond which nobody counts: no machine holds as many, and the work is refused.
constexpr double kMostParts = 1e8;

/// Parts of every layer that keep a ray's curvature small. @see kThickestSublayer_km
std::vector<int> parts_by_thickness(const Shells& shells, const std::vector<double>& scattering) {
  const double total = std::accumulate(scattering.begin(), scattering.end(), 0.0);
  const double thickest_km = thickest_sublayer_km(shells);
  std::vector<int> parts;
  for (std::size_t layer = 0; layer < scattering.size(); ++layer)
    parts.push_back(scattering[layer] > kEvenShare * total
                        ? static_cast<int>(std::ceil(layer_thickness(shells, layer) / thickest_km))
                        : 1);
  return parts;
}

std::vector<int> parts_for(const std::vector<double>& depth, double optical_step) {
  std::vector<int> parts;
  for (const double layer_depth : depth)
    parts.push_back(static_cast<int>(std::clamp(std::ceil(layer_depth / optical_step), 1.0, kMostParts)));
  return parts;
}

/// A few splittings serve most columns, so that columns of different wavelength and load fill a block: those
/// of a model haze (scale heights 8 and 2 km) of twice the extinction each. Takes the first that is fine
/// enough, or the column's own where that wastes too many sublayers (an opaque layer high up).
std::vector<int> common_parts(const Shells& shells, const std::vector<double>& depth,
                              const std::vector<int>& own, double optical_step) {
  const auto sum = [](const std::vector<int>& parts) {
    return std::accumulate(parts.begin(), parts.end(), 0.0);
  };
  if (sum(own) >= kMostParts) return own;
  for (double extinction_per_km = 0.05;; extinction_per_km *= 1.5) {
    std::vector<double> model;
    for (std::size_t layer = 0; layer < depth.size(); ++layer) {
      const double middle_km = 0.5 * (shells.levels_km[layer] + shells.levels_km[layer + 1]);
      model.push_back(extinction_per_km * (0.25 * std::exp(-middle_km / 8.0) + std::exp(-middle_km / 2.0)) *
                      layer_thickness(shells, layer));
    }
    std::vector<int> parts = parts_for(model, optical_step);
    if (sum(parts) > 2 * sum(own) + 20) return own;
    if (std::equal(own.begin(), own.end(), parts.begin(),
                   [](int mine, int common) { return mine <= common; }))
      return parts;
  }
}

/// Share of a layer's scattering that delta-M cuts off with the degrees beyond max_l and that is not a peak
/// narrow enough to pass for unscattered: f = χ_{L+1} less what is left of it at 4/3 of that degree.
struct CutOff {
  double peak;
  double wide_part;
};

/// The largest over the layers that matter.
CutOff cut_off(const OpticalColumn& column, int max_l) {
  const int first = max_l + 1;
  const int later = (4 * first + 2) / 3;
  double total = 0.0;
  std::vector<double> at_first;
  std::vector<double> at_later;
  for (const Scatterer& scatterer : column.scatterers) {
    at_first.push_back(scatterer.phase->moment(first));
    at_later.push_back(scatterer.phase->moment(later));
    for (const double depth : scatterer.scattering_depth) total += depth;
  }
  CutOff largest{0.0, 0.0};
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    double scattering = 0.0;
    double peak = 0.0;
    double narrow = 0.0;
    for (std::size_t s = 0; s < column.scatterers.size(); ++s) {
      const double depth = column.scatterers[s].scattering_depth[layer];
      scattering += depth;
      peak += depth * at_first[s];
      narrow += depth * at_later[s];
    }
    if (scattering <= 1e-3 * total) continue;
    largest.peak = std::max(largest.peak, std::abs(peak) / scattering);
    largest.wide_part = std::max(largest.wide_part, std::abs(peak - narrow) / scattering);
  }
  return largest;
}

/// Legendre degrees until delta-M cuts off little but a narrow peak; the rest follows from the degrees. A
/// Rayleigh sky needs no more than degree 2, although its radiance holds higher ones: they do not enter the
/// source.
AngularResolution angles_for(const OpticalColumn& column, const DiscretisationOptions& options) {
  // Diffraction by large particles: ForwardPeakCorrection restores it around the sun.
  constexpr double kNarrow = 0.48;
  AngularResolution angles;
  for (angles.max_l = 2; angles.max_l < kMostLegendreDegree; angles.max_l += 2) {
    const CutOff cut = cut_off(column, angles.max_l);
    if (cut.wide_part <= options.truncated_peak) break;
    if (angles.max_l >= options.narrow_peak_degree && cut.wide_part <= kNarrow * cut.peak) break;
  }
  angles.max_m = azimuthal_order_for(angles.max_l);
  angles.azimuth_nodes = azimuth_nodes_for(angles.max_m);
  angles.polar_nodes = std::max(options.least_polar_nodes,
                                static_cast<int>(std::ceil(options.polar_per_degree * angles.max_l)));
  return angles;
}

}  // namespace

DiscretisationKey discretisation_for(const LayerMerge& merge, const DiscretisationOptions& options,
                                     const OpticalColumn& column) {
  DiscretisationKey key;
  key.angles = angles_for(column, options);
  key.polarised_degree = std::min(options.polarised_degree, key.angles.max_l);
  key.cuts_peak = cut_off(column, key.angles.max_l).peak > kLeastHorizonPeak;
  const OpticalColumn merged = merge.column(column);
  // Absorption bends the source less than scattering does, and what is absorbed is dark.
  constexpr double kAbsorptionWeight = 0.25;
  std::vector<double> scaled_depth;
  for (const double extinction : merged.extinction_depth)
    scaled_depth.push_back(kAbsorptionWeight * extinction);
  for (const Scatterer& scatterer : merged.scatterers) {
    const double weight = 1.0 - kAbsorptionWeight - scatterer.phase->moment(key.angles.max_l + 1);
    for (std::size_t layer = 0; layer < scaled_depth.size(); ++layer)
      scaled_depth[layer] += weight * scatterer.scattering_depth[layer];
  }
  const double optical_step = options.optical_step;
  std::vector<int> own = parts_for(scaled_depth, optical_step);
  std::vector<double> scattering(own.size(), 0.0);
  for (const Scatterer& scatterer : merged.scatterers)
    for (std::size_t layer = 0; layer < own.size(); ++layer)
      scattering[layer] += scatterer.scattering_depth[layer];
  const std::vector<int> by_thickness = parts_by_thickness(merge.shells(), scattering);
  for (std::size_t layer = 0; layer < own.size(); ++layer)
    own[layer] = std::max(own[layer], by_thickness[layer]);
  key.sublayers = common_parts(merge.shells(), scaled_depth, own, optical_step);
  const double uppermost_km = layer_thickness(merge.shells(), own.size() - 1) / key.sublayers.back();
  const double along_km =
      std::sqrt(2.0 * std::min(merge.shells().planet_radius_km, kEarthRadius_km) * uppermost_km);
  key.grades_top = scattering.back() / key.sublayers.back() / uppermost_km * along_km > kMostDepthAlongTop;
  return key;
}

SublayerSizes sublayer_sizes(const Shells& merged, const DiscretisationKey& key) {
  const std::vector<double> levels = split_levels(merged, key.sublayers, key.grades_top);
  SublayerSizes sizes;
  sizes.count = static_cast<double>(levels.size()) - 1.0;
  for (std::size_t level = 0; level + 1 < levels.size(); ++level)
    sizes.thickest_km = std::max(sizes.thickest_km, levels[level + 1] - levels[level]);
  return sizes;
}

BeamGeometry::BeamGeometry(const CommonGrid& common, const ShellGeometry& sublayers) {
  const ShellGeometry& layers = common.layers;
  std::vector<double> altitude_km = sublayers.levels_km();
  for (int sublayer = 0; sublayer < sublayers.layers(); ++sublayer) {
    first_piece_.push_back(static_cast<int>(piece_layer_.size()));
    double bottom = sublayers.level_km(sublayer);
    while (bottom < sublayers.level_km(sublayer + 1)) {
      const int layer = layers.layer_of(bottom);
      const double top = std::min(layers.level_km(layer + 1), sublayers.level_km(sublayer + 1));
      piece_layer_.push_back(layer);
      piece_thickness_km_.push_back(static_cast<float>(top - bottom));
      altitude_km.push_back(0.5 * (bottom + top));
      bottom = top;
    }
  }
  first_piece_.push_back(static_cast<int>(piece_layer_.size()));
  for (const double altitude : altitude_km)
    for (const double sun_deg : common.sun_nodes_deg)
      weights_.push_back(common.slant_depth.weights_towards(altitude, std::cos(sun_deg * kRadiansPerDegree)));
}

Discretisation::Discretisation(const CommonGrid& common_, const DiscretisationKey& key)
    : common(common_),
      sublayers(split_levels(common.merge.shells(), key.sublayers, key.grades_top),
                common.shells.planet_radius_km),
      ray_levels(joined_levels(common.layers, sublayers), common.shells.planet_radius_km),
      layer_of_sublayer(layers_of(common.merge.shells(), sublayers)),
      angles(key.angles),
      cuts_peak(key.cuts_peak),
      horizon(angles, sublayers, layer_of_sublayer),
      stencil(sublayers, angles, common.sun_nodes_deg),
      beam(common, sublayers) {
  if (key.polarised_degree > 0) polarised.emplace(angles, key.polarised_degree);
}

bool Discretisation::needs_source_at(double altitude_km) const {
  const auto holds = [&](const ShellGeometry& shells) {
    return std::binary_search(shells.levels_km().begin(), shells.levels_km().end(), altitude_km);
  };
  return holds(sublayers) || !holds(ray_levels);
}

}  // namespace skylut::transfer
