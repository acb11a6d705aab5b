#pragma once

#include <span>

#include "skylut/models/preetham_matrices.hpp"

namespace skylut::forms_detail {

/// The zenith of one sky.
struct ZenithSample {
  double turbidity = 2.0;
  double sun_zenith_rad = 0.0;
  Yxy colour;  ///< Y in kcd/m²
};

/// Preetham's zenith formulas fitted to zeniths, put into `matrices`: Y by least squares of relative
/// differences, its two constants of χ by a search that narrows (χ short of 90° for every sample); x and y by
/// least squares, quadratic in T and cubic in θ_s.
/// @param samples  3 or more turbidities, each with 4 or more suns
void fit_zenith(std::span<const ZenithSample> samples, PreethamMatrices& matrices);

}  // namespace skylut::forms_detail
