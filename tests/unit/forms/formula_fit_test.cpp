#include "formula_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/forms/dome_views.hpp"
#include "skylut/models/hosek_wilkie.hpp"
#include "skylut/models/perez.hpp"

namespace skylut::forms_detail {
namespace {

// Samples of a formula with known curves, at suns along the axis.
std::vector<FormulaSample> samples_of(const SkyFormula& formula, const FormulaCurves& curves) {
  std::vector<FormulaSample> samples;
  for (const double along : {0.0, 0.15, 0.4, 0.5, 0.75, 1.0}) {
    const Direction sun{90.0 * (1.0 - along), 0.0};
    const std::vector<double> coefficients = curves.at(along);
    for (const Direction& direction : fitting_views(sun).views) {
      const double gamma_rad = angle_between(direction, sun);
      FormulaSample sample{.view = {std::cos(direction.zenith_deg * kRadiansPerDegree), gamma_rad,
                                    std::cos(gamma_rad), sun.zenith_deg * kRadiansPerDegree},
                           .along = along};
      sample.target = 2.5 * formula.value(coefficients, sample.view, {});
      sample.scale = 2.5;
      sample.weight = 1.0 / sample.target;
      samples.push_back(sample);
    }
  }
  return samples;
}

void expect_gradient(const SkyFormula& formula, const std::vector<double>& at) {
  const FormulaView view{0.3, 0.7, std::cos(0.7), 1.1};
  std::vector<double> gradient(at.size());
  formula.value(at, view, gradient);
  for (std::size_t i = 0; i < at.size(); ++i) {
    constexpr double kStep = 1e-6;
    std::vector<double> beside = at;
    beside[i] += kStep;
    const double above = formula.value(beside, view, {});
    beside[i] -= 2.0 * kStep;
    EXPECT_NEAR(gradient[i], (above - formula.value(beside, view, {})) / (2.0 * kStep),
                1e-6 * (1.0 + std::abs(gradient[i])))
        << i;
  }
}

const std::vector<double> kHosekWilkie{-1.1, -0.3, 0.6, 1.4, -2.5, 0.2, 0.15, 0.7, 0.4};

TEST(FormulaFit, GradientsAreThoseOfTheFormulas) {
  expect_gradient(PerezRatio(), {-0.9, -0.4, 4.0, -2.2, 0.3});
  expect_gradient(HosekWilkieFormula(), kHosekWilkie);
}

TEST(FormulaFit, FormulasAreThoseThatModelsEvaluate) {
  const FormulaView view{0.3, 0.7, std::cos(0.7), 1.1};
  const PerezCoefficients k{-0.9, -0.4, 4.0, -2.2, 0.3};
  EXPECT_NEAR(PerezRatio().value(k.values(), view, {}), perez_relative(k, std::acos(0.3), 0.7, 1.1), 1e-14);
  std::vector<double> gradient(9);
  EXPECT_NEAR(HosekWilkieFormula().value(kHosekWilkie, view, gradient),
              HosekWilkieFormula().value(kHosekWilkie, view, {}), 1e-14);
}

TEST(FormulaFit, FindsPerezCoefficientsThatChangeLinearly) {
  const PerezRatio formula;
  const FormulaCurves known{.degree = 1,
                            .points = {-1.1, -0.7, -0.28, -1.2, 5.0, 3.0, -2.3, -1.9, 0.24, 0.1}};
  const std::vector<FormulaSample> samples = samples_of(formula, known);
  const FormulaCurves found = fit_formula(formula, samples, 1);
  EXPECT_LT(found.rms, 1e-7);
  for (std::size_t i = 0; i < known.points.size(); ++i)
    EXPECT_NEAR(found.points[i], known.points[i], 1e-5) << i;
}

// Nine coefficients trade among one another, values do not.
TEST(FormulaFit, FindsHosekWilkieCurves) {
  const HosekWilkieFormula formula;
  FormulaCurves known{.degree = 2, .points = {}};
  for (const double coefficient : kHosekWilkie)
    for (const double factor : {1.0, 1.1, 0.8}) known.points.push_back(coefficient * factor);
  const std::vector<FormulaSample> samples = samples_of(formula, known);
  const FormulaCurves found = fit_formula(formula, samples, 2);
  EXPECT_LT(found.rms, 1e-4);
}

TEST(FormulaFit, ANeighboursCurvesAreKeptWhereTheyDoAsWell) {
  const PerezRatio formula;
  const FormulaCurves known{.degree = 1,
                            .points = {-1.1, -0.7, -0.28, -1.2, 5.0, 3.0, -2.3, -1.9, 0.24, 0.1}};
  const FormulaCurves found = fit_formula(formula, samples_of(formula, known), 1, &known);
  EXPECT_LT(found.rms, 1e-9);
  EXPECT_EQ(found.points, known.points);
}

TEST(FormulaFit, StaysWithinTheBounds) {
  // The gradation rises steeper towards the horizon than B's bound allows.
  const PerezRatio formula;
  FormulaCurves known{.degree = 0, .points = {-0.5, -1e-4, 2.0, -3.0, 0.1}};
  const FormulaCurves found = fit_formula(formula, samples_of(formula, known), 0);
  EXPECT_LE(found.points[1], -1e-3);
}

}  // namespace
}  // namespace skylut::forms_detail
