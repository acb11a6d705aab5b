#pragma once

#include <string>
#include <vector>

#include "skylut/atmosphere/turbidity.hpp"
#include "skylut/core/directions.hpp"

namespace skylut {

/// The conditions of a table's rows under a name.
struct NamedGrid {
  std::string name;
  std::string what;  ///< in a few words
  std::vector<double> altitudes_km;
  TurbidityKind turbidity_kind = TurbidityKind::aod500;
  std::vector<double> turbidities;
  std::vector<Direction> suns;
  bool for_between = false;  ///< meant to be interpolated: its error between the rows is measured and stated
};

/// utm2005   the UTM report's 5 altitudes × 3 loads × 5 suns: rows to look up
/// preetham  Preetham et al. 1999's domain: the ground, T 2 to 6, 12 suns
/// runtime   dense enough to be interpolated: 0-30 km, aod500 0-1, suns 0-96° [fit.md T5]
const std::vector<NamedGrid>& named_grids();

/// Their names.
std::vector<std::string> grid_names();

/// @throws InputError  naming the text and the grids there are
const NamedGrid& named_grid(const std::string& name);

}  // namespace skylut
