#include "skylut/table/named_grids.hpp"

#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut {

namespace {

std::vector<Direction> suns_at(const std::vector<double>& zeniths_deg, double azimuth_deg) {
  std::vector<Direction> suns;
  for (const double zenith_deg : zeniths_deg) suns.push_back({zenith_deg, azimuth_deg});
  return suns;
}

std::vector<NamedGrid> grids() {
  return {{"utm2005",
           {0.0, 6.0, 12.0, 20.0, 30.0},
           TurbidityKind::aod500,
           {0.0, 0.5, 1.0},
           {{90.0, 90.0}, {45.0, 90.0}, {0.0, 0.0}, {45.0, 270.0}, {90.0, 270.0}}},
          {"preetham",
           {0.0},
           TurbidityKind::preetham_t,
           {2.0, 3.0, 4.0, 5.0, 6.0},
           suns_at({0, 10, 20, 30, 40, 50, 60, 65, 70, 75, 80, 85}, 180.0)},
          {"runtime",
           {0.0, 1.0, 2.0, 4.0, 6.0, 9.0, 12.0, 16.0, 20.0, 25.0, 30.0},
           TurbidityKind::aod500,
           {0.0, 0.02, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0},
           suns_at({0, 10, 20, 30, 40, 50, 60, 66, 72, 76, 79, 82, 84, 86, 87, 88, 89, 90}, 180.0)}};
}

}  // namespace

std::vector<std::string> grid_names() {
  std::vector<std::string> names;
  for (const NamedGrid& grid : grids()) names.push_back(grid.name);
  return names;
}

NamedGrid named_grid(const std::string& name) {
  for (NamedGrid& grid : grids())
    if (grid.name == name) return grid;
  throw InputError("grid '{}': must be {}{}", name, listed(grid_names()), suggested(name, grid_names()));
}

}  // namespace skylut
