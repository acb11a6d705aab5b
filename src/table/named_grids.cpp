#include "skylut/table/named_grids.hpp"

#include "skylut/core/errors.hpp"
#include "skylut/core/suggestion.hpp"

namespace skylut {

namespace {

std::vector<Direction> in_the_south(const std::vector<double>& sun_zeniths_deg) {
  std::vector<Direction> suns;
  for (const double zenith_deg : sun_zeniths_deg) suns.push_back({zenith_deg, 180.0});
  return suns;
}

}  // namespace

const std::vector<NamedGrid>& named_grids() {
  static const std::vector<NamedGrid> grids{
      {.name = "utm2005",
       .what = "the UTM report's 5 altitudes, 3 loads, 5 suns",
       .altitudes_km = {0.0, 6.0, 12.0, 20.0, 30.0},
       .turbidities = {0.0, 0.5, 1.0},
       .suns = {{90.0, 90.0}, {45.0, 90.0}, {0.0, 0.0}, {45.0, 270.0}, {90.0, 270.0}}},
      {.name = "preetham",
       .what = "the ground, T 2 to 6, 12 suns",
       .altitudes_km = {0.0},
       .turbidity_kind = TurbidityKind::preetham_t,
       .turbidities = {2.0, 3.0, 4.0, 5.0, 6.0},
       .suns = in_the_south({0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0})},
      // The haze lies in the lowest kilometres, and little of it changes clean air most; the light of a low
      // sun falls fastest. The first sun is not at the zenith, where angles to the sun and to the vertical
      // are one and the formula's two factors cannot be told apart.
      {.name = "runtime",
       .what = "dense enough to be interpolated: 16 altitudes, 7 loads, 21 suns",
       .altitudes_km = {0.0, 0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.5, 15.0, 17.5, 20.0, 22.5, 25.0, 27.5,
                        30.0},
       .turbidities = {0.0, 0.01, 0.05, 0.15, 0.35, 0.625, 1.0},
       .suns = in_the_south({5.0,  10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 65.0, 70.0, 75.0, 80.0,
                             83.0, 86.0, 88.0, 90.0, 91.0, 92.0, 93.0, 94.0, 95.0, 96.0}),
       .for_between = true}};
  return grids;
}

std::vector<std::string> grid_names() {
  std::vector<std::string> names;
  for (const NamedGrid& grid : named_grids()) names.push_back(grid.name);
  return names;
}

const NamedGrid& named_grid(const std::string& name) {
  for (const NamedGrid& grid : named_grids())
    if (grid.name == name) return grid;
  throw InputError("grid '{}': must be {}{}", name, listed(grid_names()), suggested(name, grid_names()));
}

}  // namespace skylut
