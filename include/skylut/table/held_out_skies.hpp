#pragma once

#include <vector>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/models/sky_model.hpp"
#include "skylut/table/fit_table.hpp"

namespace skylut {

/// A sky at conditions that a table has no row for, and the row that it would be alone.
struct HeldOutSky {
  TableEntry alone;
  std::vector<Direction> directions;
  std::vector<double> solid_angles_sr;  ///< [direction]
  std::vector<Yxy> colours;             ///< [direction], simulated; Y in cd/m²
};

/// Altitudes and suns under one load.
struct HeldOutConditions {
  double turbidity = 0.0;
  std::vector<double> altitudes_km;
  std::vector<double> sun_zeniths_deg;  ///< those above the horizon first
};

/// Conditions spread evenly over a table's domain (Halton 1960, bases 2, 3 and 5): 8 loads, under each 5
/// altitudes, 5 suns above and, if the domain goes there, 2 below the horizon; fewer along an axis of one
/// value. The same for the same domain.
std::vector<HeldOutConditions> held_out_conditions(const ModelInfo& domain);

/// Simulates and fits, each row alone. @param scene  whose altitudes, turbidities and suns are not used
/// @throws  as simulate_table_skies and fit_table
std::vector<HeldOutSky> held_out_skies(const Context& context, const SkyScene& scene,
                                       const TransferOptions& transfer, const TableSampling& sampling,
                                       const TableFitOptions& fit, const ModelInfo& domain);

}  // namespace skylut
