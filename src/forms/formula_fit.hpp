#pragma once

#include <span>
#include <vector>

#include "sky_formula.hpp"

namespace skylut::forms_detail {

/// One residual: weight (scale · value - target).
struct FormulaSample {
  FormulaView view;
  double along = 0.0;  ///< where on the axis along which the coefficients change, [0, 1]
  double scale = 1.0;
  double target = 0.0;
  double weight = 1.0;
};

/// Coefficients that change along one axis as Bézier curves.
struct FormulaCurves {
  std::size_t degree = 0;
  std::vector<double> points;  ///< [coefficient][degree + 1]
  double rms = 0.0;            ///< of the residuals: root of their mean square
  int iterations = 0;

  /// The coefficients at one place of the axis.
  std::vector<double> at(double along) const;
};

/// Fits a formula whose coefficients change along an axis as Bézier curves of some degree, by
/// Levenberg-Marquardt (Ceres), within the formula's bounds (a Bézier curve stays among its points, so that
/// bounded points bound the coefficients everywhere). First with constant coefficients, from the best of the
/// formula's starts, for which the linear ones are solved; then degree by degree, each from the one before,
/// whose curve it holds exactly: so that the coefficients keep to one branch along the whole axis, and no fit
/// is worse than one of lower degree. The best few go all the way.
/// @param near  curves of the same degree, of a neighbouring channel: a fit from there is preferred unless
///              another's residuals are smaller by more than 5 %, so that the errors of channels are alike
///              and leave colours right
/// @throws WorkError  if no start has a finite cost
FormulaCurves fit_formula(const SkyFormula& formula, std::span<const FormulaSample> samples,
                          std::size_t degree, const FormulaCurves* near = nullptr);

/// The better of some curves and of where a search from others ends: the same samples, the same degree.
FormulaCurves better_of(const SkyFormula& formula, std::span<const FormulaSample> samples,
                        const FormulaCurves& known, const FormulaCurves& start);

}  // namespace skylut::forms_detail
