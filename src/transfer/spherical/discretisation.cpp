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

double layer_thickness(const Shells& shells, std::size_t layer) {
  return shells.levels_km[layer + 1] - shells.levels_km[layer];
}

std::vector<double> split_levels(const Shells& shells, const std::vector<int>& parts) {
  std::vector<double> levels{shells.levels_km.front()};
  for (std::size_t layer = 0; layer < parts.size(); ++layer) {
    const double bottom = shells.levels_km[layer];
    const double step = layer_thickness(shells, layer) / parts[layer];
    if (layer == 0)
      for (double height = kLowestSublayer_km; height < 0.75 * step; height *= 2.0)
        levels.push_back(bottom + height);
    for (int part = 1; part <= parts[layer]; ++part)
      levels.push_back(part == parts[layer] ? shells.levels_km[layer + 1] : bottom + part * step);
  }
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

std::vector<int> parts_for(const std::vector<double>& depth, double optical_step) {
  std::vector<int> parts;
  for (const double layer_depth : depth)
    parts.push_back(std::max(1, static_cast<int>(std::ceil(layer_depth / optical_step))));
  return parts;
}

/// A few splittings serve most columns, so that columns of different wavelength and load fill a block: those
/// of a model haze (scale heights 8 and 2 km) of twice the extinction each. Takes the first that is fine
/// enough, or the column's own where that wastes too many sublayers (an opaque layer high up).
std::vector<int> common_parts(const Shells& shells, const std::vector<double>& depth,
                              const std::vector<int>& own, double optical_step) {
  const auto sum = [](const std::vector<int>& parts) {
    return std::accumulate(parts.begin(), parts.end(), 0);
  };
  for (double extinction_per_km = 0.05;; extinction_per_km *= 1.5) {
    std::vector<double> model;
    for (std::size_t layer = 0; layer < depth.size(); ++layer) {
      const double middle_km = 0.5 * (shells.levels_km[layer] + shells.levels_km[layer + 1]);
      model.push_back(extinction_per_km * (0.25 * std::exp(-middle_km / 8.0) + std::exp(-middle_km / 2.0)) *
                      layer_thickness(shells, layer));
    }
    const std::vector<int> parts = parts_for(model, optical_step);
    if (sum(parts) > 2 * sum(own) + 20) return own;
    if (std::equal(own.begin(), own.end(), parts.begin(),
                   [](int mine, int common) { return mine <= common; }))
      return parts;
  }
}

/// Local solar zenith angles that carry the diffuse field: dense at the terminator, where it changes by
/// orders of magnitude, and beyond the largest sun by what a horizontal ray can cover (√(2·100/6371) = 10°).
std::vector<double> sun_nodes(bool dense) {
  if (!dense)
    return {0,  10,   20, 30,   40, 50,   58, 65, 70, 74,    77,   80,    82, 84, 85.5, 87, 88,
            89, 89.5, 90, 90.5, 91, 91.5, 92, 93, 94, 94.75, 95.5, 96.25, 97, 99, 101,  104};
  std::vector<double> nodes;
  for (double node = 0.0; node < 70.0; node += 5.0) nodes.push_back(node);
  for (double node = 70.0; node < 84.0; node += 1.0) nodes.push_back(node);
  for (double node = 84.0; node < 98.0; node += 0.5) nodes.push_back(node);
  for (double node = 98.0; node <= 107.0; node += 1.0) nodes.push_back(node);
  return nodes;
}

/// What delta-M gets wrong with degrees below l: it takes all moments from χ_l upwards to be alike, a peak in
/// one direction. How far χ_l falls to degree 5l/3, as a share of a layer's scattering, at most over the
/// layers that matter. (Henyey-Greenstein: nearly χ_l. The narrow peak of large particles falls slowly.)
double error_of_truncation(const OpticalColumn& column, int l) {
  double total = 0.0;
  for (const Scatterer& scatterer : column.scatterers)
    for (const double depth : scatterer.scattering_depth) total += depth;
  double largest = 0.0;
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    double scattering = 0.0;
    double moment = 0.0;
    for (const Scatterer& scatterer : column.scatterers) {
      scattering += scatterer.scattering_depth[layer];
      moment += scatterer.scattering_depth[layer] *
                (scatterer.phase->moment(l) - scatterer.phase->moment(5 * l / 3));
    }
    if (scattering > 1e-3 * total) largest = std::max(largest, std::abs(moment) / scattering);
  }
  return largest;
}

/// Legendre degrees until delta-M cuts off little; the rest follows from the degrees. A Rayleigh sky needs
/// no more than degree 2, although its radiance holds higher ones: they do not enter the source.
AngularResolution angles_for(const OpticalColumn& column, const QualityLimits& limits) {
  constexpr int kMostDegrees = 30;
  AngularResolution angles;
  angles.max_l = 2;
  while (angles.max_l < kMostDegrees && error_of_truncation(column, angles.max_l + 1) > limits.truncated_peak)
    angles.max_l += 2;
  angles.max_m = (3 * angles.max_l + 3) / 4;
  angles.azimuth_nodes = (angles.max_m + 2) / 2 * 2;
  angles.polar_nodes =
      std::max(limits.least_polar_nodes, static_cast<int>(std::ceil(limits.polar_per_degree * angles.max_l)));
  return angles;
}

}  // namespace

QualityLimits limits_of(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {0.2, 0.03, 0.6, 8, false, true, 20.0, 2.0, 3e-3};
    case Quality::standard:
      return {0.04, 0.015, 0.7, 10, false, true, 10.0, 0.25, 1e-3};
    case Quality::reference:
      return {0.02, 0.006, 0.9, 16, true, false, 5.0, 0.125, 1e-4};
  }
  return limits_of(Quality::standard);
}

DiscretisationKey discretisation_for(const Shells& shells, const OpticalColumn& column, Quality quality) {
  const QualityLimits limits = limits_of(quality);
  DiscretisationKey key;
  key.angles = angles_for(column, limits);
  const LayerMerge merge(shells, !limits.merge_layers);
  const OpticalColumn merged = merge.column(column);
  std::vector<double> scaled_depth = merged.extinction_depth;
  for (const Scatterer& scatterer : merged.scatterers) {
    const double peak = scatterer.phase->moment(key.angles.max_l + 1);
    for (std::size_t layer = 0; layer < scaled_depth.size(); ++layer)
      scaled_depth[layer] -= scatterer.scattering_depth[layer] * peak;
  }
  const std::vector<int> own = parts_for(scaled_depth, limits.optical_step);
  key.sublayers = common_parts(merge.shells(), scaled_depth, own, limits.optical_step);
  return key;
}

BeamGeometry::BeamGeometry(const ShellGeometry& layers, const ShellGeometry& sublayers,
                           const std::vector<double>& sun_nodes_deg)
    : nodes_(static_cast<int>(sun_nodes_deg.size())), layers_(static_cast<std::size_t>(layers.layers())) {
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

  points_ = static_cast<int>(altitude_km.size());
  lit_.resize(static_cast<std::size_t>(points_ * nodes_));
  path_km_.resize(lit_.size() * layers_);
  std::vector<double> length;
  for (std::size_t at = 0; at < lit_.size(); ++at) {
    const std::size_t node = at % sun_nodes_deg.size();
    const double cosine = std::cos(sun_nodes_deg[node] * kRadiansPerDegree);
    lit_[at] = layers.path_to_top(altitude_km[at / sun_nodes_deg.size()], cosine, length);
    if (lit_[at])
      std::transform(length.begin(), length.end(),
                     path_km_.begin() + static_cast<std::ptrdiff_t>(at * layers_),
                     [](double value) { return static_cast<float>(value); });
  }
}

Discretisation::Discretisation(const Shells& shells_, const DiscretisationKey& key, Quality quality)
    : limits(limits_of(quality)),
      shells(shells_),
      merge(shells, !limits.merge_layers),
      layers(shells.levels_km, shells.planet_radius_km),
      sublayers(split_levels(merge.shells(), key.sublayers), shells.planet_radius_km),
      ray_steps(joined_levels(layers, sublayers), shells.planet_radius_km),
      layer_of_sublayer(layers_of(merge.shells(), sublayers)),
      angles(key.angles),
      sun_nodes_deg(sun_nodes(limits.dense_sun_nodes)),
      stencil(sublayers, angles, sun_nodes_deg),
      beam(layers, sublayers, sun_nodes_deg) {}

}  // namespace skylut::transfer
