#pragma once

#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/core/directions.hpp"

namespace skylut {

/// Nodes of a table that go by a name.
struct NamedGrid {
  std::string name;
  std::vector<double> altitudes_km;
  TurbidityKind turbidity_kind = TurbidityKind::aod500;
  std::vector<double> turbidities;
  std::vector<Direction> suns;
};

/// utm2005 (the report's 75), preetham (12 suns × T 2-6 on the ground) or runtime (dense enough to blend).
std::vector<std::string> grid_names();

/// @throws InputError  naming the text, the grids there are and the one probably meant
NamedGrid named_grid(const std::string& name);

}  // namespace skylut
