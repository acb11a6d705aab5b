#include "medium.hpp"

namespace skylut::transfer {

namespace {

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

}  // namespace

QualityLimits limits_of(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {0.2, 0.03, 0.6, 8, false, true, 3, 20.0, 2.0, 3e-3};
    case Quality::standard:
      return {0.04, 0.015, 0.7, 10, false, true, 3, 10.0, 0.25, 1e-3};
    case Quality::reference:
      return {0.02, 0.006, 0.9, 16, true, false, 1, 5.0, 0.125, 1e-4};
  }
  return limits_of(Quality::standard);
}

Medium::Medium(const Shells& shells_, Quality quality)
    : limits(limits_of(quality)),
      shells(shells_),
      layers(shells.levels_km, shells.planet_radius_km),
      merge(shells, !limits.merge_layers),
      sun_depth(layers),
      sun_nodes_deg(sun_nodes(limits.dense_sun_nodes)),
      sun_interpolation(sun_nodes_deg) {}

}  // namespace skylut::transfer
