#include "common_grid.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace skylut::transfer {

namespace {

// Ranges by their ends and the step within; whole fractions of the steps keep the nodes exact.
struct Range {
  double first;
  double last;
  double step;
};

std::vector<double> even_nodes(std::initializer_list<Range> ranges, int density) {
  std::vector<double> nodes;
  for (const Range& range : ranges) {
    const double step = range.step / density;
    const int count = static_cast<int>(std::lround((range.last - range.first) / step));
    for (int i = 0; i < count; ++i) nodes.push_back(range.first + i * step);
  }
  nodes.push_back((ranges.end() - 1)->last);
  return nodes;
}

}  // namespace

// Dense at the terminator, where the field changes by orders of magnitude, and beyond the largest sun by what
// a horizontal ray can cover (√(2·100/6371) = 10°).
std::vector<double> sun_nodes(int density) {
  if (density == 0)
    return {0,  10,   20, 30,   40, 50,   58, 65, 70, 74,    77,   80,    82, 84, 85.5, 87, 88,
            89, 89.5, 90, 90.5, 91, 91.5, 92, 93, 94, 94.75, 95.5, 96.25, 97, 99, 101,  104};
  return even_nodes({{0.0, 70.0, 5.0}, {70.0, 84.0, 1.0}, {84.0, 98.0, 0.5}, {98.0, 107.0, 1.0}}, density);
}

std::vector<double> deep_twilight_nodes(int density) {
  if (density == 0)
    return {80, 82, 84,    85.5, 87,    88, 89, 89.5, 90,  90.5, 91,    91.5, 92,
            93, 94, 94.75, 95.5, 96.25, 97, 98, 99,   100, 101,  102.5, 105,  109};
  return even_nodes({{80.0, 84.0, 1.0}, {84.0, 101.0, 0.5}, {101.0, 109.0, 1.0}}, density);
}

CommonGrid::CommonGrid(const Shells& shells_, const DiscretisationOptions& discretisation_,
                       std::vector<double> sun_nodes)
    : discretisation(discretisation_),
      shells(shells_),
      layers(shells.levels_km, shells.planet_radius_km),
      refractive(shells.refractivity.empty() ? nullptr : std::make_unique<const RefractiveShells>(shells)),
      merge(shells, !discretisation.merge_layers),
      slant_depth(refractive ? SlantDepthGrid(*refractive) : SlantDepthGrid(layers)),
      sun_nodes_deg(std::move(sun_nodes)),
      sun_interpolation(sun_nodes_deg) {}

CommonGrid::CommonGrid(const Shells& shells_, const DiscretisationOptions& discretisation_)
    : CommonGrid(shells_, discretisation_, sun_nodes(discretisation_.sun_node_density)) {}

}  // namespace skylut::transfer
