#pragma once

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/models/perez.hpp"

namespace skylut {

/// One row of the coefficient table: a sky as three Perez formulas.
struct TableEntry {
  double altitude_km = 0.0;
  double turbidity = 0.0;  ///< in the table's turbidity kind
  Direction sun;
  PerezCoefficients Y;
  PerezCoefficients x;
  PerezCoefficients y;
  Yxy zenith;  ///< Y in kcd/m²
  double rmse_Y_rel = 0.0;
  double rmse_x = 0.0;
  double rmse_y = 0.0;

  bool operator==(const TableEntry&) const = default;
};

}  // namespace skylut
