#pragma once

#include <string>

#include "skylut/colour/yxy.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/models/perez.hpp"

namespace skylut {

/// What else is known of one formula of a row. Y: relative; x, y: absolute.
struct FormulaNotes {
  double rmse_horizon = 0.0;  ///< of the last 10° above the formula's horizon
  double worst = 0.0;         ///< the largest error in size, signed, formula minus simulation
  Direction worst_direction;
  /// One digit for each of A…E, 1 for those that the data do not fix: "11000" for A and B.
  std::string undetermined = "00000";
  std::string at_bound = "00000";  ///< likewise, those on a bound of the fit

  bool operator==(const FormulaNotes&) const = default;
};

/// One row of the coefficient table: a sky as three Perez formulas.
struct TableEntry {
  double altitude_km = 0.0;
  double turbidity = 0.0;  ///< in the table's turbidity kind
  Direction sun;
  PerezCoefficients Y;
  PerezCoefficients x;
  PerezCoefficients y;
  Yxy zenith;               ///< Y in kcd/m²
  double rmse_Y_rel = 0.0;  ///< by solid angle, over directions that the fit did not see
  double rmse_x = 0.0;
  double rmse_y = 0.0;
  double horizon_zenith_deg = 90.0;  ///< where the formulas have their horizon: views are stretched to it
  FormulaNotes notes_Y;
  FormulaNotes notes_x;
  FormulaNotes notes_y;
  double Y_below_90_kcd_m2 = 0.0;  ///< mean luminance between 90° and the geometric horizon; 0 on the ground
  double light_below_90 = 0.0;     ///< its part of all the sky's light above the geometric horizon, 0 to 1

  bool operator==(const TableEntry&) const = default;
};

}  // namespace skylut
