#include "discretisation.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<int> layers_of(const ShellGeometry& layers, const ShellGeometry& sublayers) {
  std::vector<int> layer_of;
  for (int sublayer = 0; sublayer < sublayers.layers(); ++sublayer)
    layer_of.push_back(
        layers.layer_of(0.5 * (sublayers.level_km(sublayer) + sublayers.level_km(sublayer + 1))));
  return layer_of;
}

/// Local solar zenith angles that carry the diffuse field: dense at the terminator, where it changes by
/// orders of magnitude, and beyond the largest sun by what a horizontal ray can cover (√(2·100/6371) = 10°).
std::vector<double> sun_nodes(bool dense) {
  if (!dense)
    return {0,    10, 20, 30, 40, 50, 58, 65, 70, 74,   77, 80, 82,  84,
            85.5, 87, 88, 89, 90, 91, 92, 93, 94, 95.5, 97, 99, 101, 104};
  std::vector<double> nodes;
  for (double node = 0.0; node < 70.0; node += 5.0) nodes.push_back(node);
  for (double node = 70.0; node < 84.0; node += 1.0) nodes.push_back(node);
  for (double node = 84.0; node < 98.0; node += 0.5) nodes.push_back(node);
  for (double node = 98.0; node <= 107.0; node += 1.0) nodes.push_back(node);
  return nodes;
}

/// Share χ_l of a layer's scattering that degree l still carries, at most over the layers that matter.
double largest_moment(const OpticalColumn& column, int l) {
  double total = 0.0;
  for (const Scatterer& scatterer : column.scatterers)
    for (const double depth : scatterer.scattering_depth) total += depth;
  double largest = 0.0;
  for (std::size_t layer = 0; layer < column.extinction_depth.size(); ++layer) {
    double scattering = 0.0;
    double moment = 0.0;
    for (const Scatterer& scatterer : column.scatterers) {
      scattering += scatterer.scattering_depth[layer];
      moment += scatterer.scattering_depth[layer] * scatterer.phase->moment(l);
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
  while (angles.max_l < kMostDegrees && largest_moment(column, angles.max_l + 1) > limits.truncated_peak)
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
      return {0.2, 0.03, 0.6, 8, false, 20.0, 2.0, 3e-3};
    case Quality::standard:
      return {0.05, 0.012, 0.7, 10, false, 10.0, 0.5, 1e-3};
    case Quality::reference:
      return {0.02, 0.006, 0.9, 16, true, 5.0, 0.25, 1e-4};
  }
  return limits_of(Quality::standard);
}

DiscretisationKey discretisation_for(const Shells& shells, const OpticalColumn& column, Quality quality) {
  const QualityLimits limits = limits_of(quality);
  DiscretisationKey key;
  key.angles = angles_for(column, limits);
  for (std::size_t layer = 0; layer + 1 < shells.levels_km.size(); ++layer) {
    double depth = column.extinction_depth[layer];
    for (const Scatterer& scatterer : column.scatterers)
      depth -= scatterer.scattering_depth[layer] * scatterer.phase->moment(key.angles.max_l + 1);
    int parts = 1;
    while (depth / parts > limits.optical_step) parts *= 2;
    key.sublayers.push_back(parts);
  }
  return key;
}

BeamGeometry::BeamGeometry(const ShellGeometry& layers, const ShellGeometry& sublayers,
                           const std::vector<double>& sun_nodes_deg)
    : points_(2 * sublayers.levels() - 1),
      nodes_(static_cast<int>(sun_nodes_deg.size())),
      layers_(static_cast<std::size_t>(layers.layers())) {
  lit_.resize(static_cast<std::size_t>(points_ * nodes_));
  path_km_.resize(lit_.size() * layers_);
  std::vector<double> length;
  for (int point = 0; point < points_; ++point) {
    const int level = point / 2;
    const double altitude = point % 2 == 0
                                ? sublayers.level_km(level)
                                : 0.5 * (sublayers.level_km(level) + sublayers.level_km(level + 1));
    for (int node = 0; node < nodes_; ++node) {
      const auto at = static_cast<std::size_t>(point * nodes_ + node);
      const double cosine = std::cos(sun_nodes_deg[static_cast<std::size_t>(node)] * kRadiansPerDegree);
      lit_[at] = layers.path_to_top(altitude, cosine, length);
      if (lit_[at])
        std::transform(length.begin(), length.end(),
                       path_km_.begin() + static_cast<std::ptrdiff_t>(at * layers_),
                       [](double value) { return static_cast<float>(value); });
    }
  }
}

Discretisation::Discretisation(const Shells& shells, const DiscretisationKey& key, Quality quality)
    : layers(shells.levels_km, shells.planet_radius_km),
      sublayers(split_levels(shells, key.sublayers), shells.planet_radius_km),
      layer_of_sublayer(layers_of(layers, sublayers)),
      angles(key.angles),
      limits(limits_of(quality)),
      sun_nodes_deg(sun_nodes(limits.dense_sun_nodes)),
      stencil(sublayers, angles, sun_nodes_deg),
      beam(layers, sublayers, sun_nodes_deg) {}

}  // namespace skylut::transfer
