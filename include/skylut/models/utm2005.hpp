#pragma once

#include <string>
#include <vector>

#include "skylut/colour/cie1931.hpp"
#include "skylut/core/directions.hpp"
#include "skylut/models/perez.hpp"

namespace skylut {

struct Context;

/// One legible row of appendix A of the UTM report 2005. It prints a single set A…E per row, not three.
struct Utm2005Row {
  double altitude_km = 0.0;
  double turbidity = 0.0;
  Direction sun;
  PerezCoefficients coefficients;
  Yxy zenith;  ///< as printed; Y taken as kcd/m²
};

/// What makes a published row impossible; none set: plausible.
struct Utm2005Verdict {
  bool impossible_chromaticity = false;  ///< zenith x, y outside the spectral locus: no light has it
  bool infinite_horizon = false;         ///< B > 0: e^{B/cosθ} is infinite at the horizon
  bool mirror_differs = false;           ///< the row of the mirror-symmetric sun is legible and not equal
  bool dark_zenith = false;              ///< zenith luminance not > 0

  bool plausible() const {
    return !impossible_chromaticity && !infinite_horizon && !mirror_differs && !dark_zenith;
  }
  /// "plausible", or what fails, in short: "chromaticity+horizon+mirror+dark".
  std::string text() const;
};

/// Reads profiles/reference/utm2005_appendix_a.csv.
/// @throws WorkError   if it is missing
/// @throws InputError  "file:line: …" if it is broken
std::vector<Utm2005Row> load_utm2005(const Context& context);

/// One verdict per row; mirrors are looked for among the rows.
std::vector<Utm2005Verdict> judge_utm2005(const std::vector<Utm2005Row>& rows,
                                          const ColourMatching& matching);

}  // namespace skylut
