#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace skylut::forms_detail {

/// Where a formula is taken.
struct FormulaView {
  double cos_zenith = 1.0;
  double gamma_rad = 0.0;
  double cos_gamma = 1.0;
  double sun_zenith_rad = 0.0;
};

/// Bounds of one coefficient; infinite where it is free.
struct CoefficientBounds {
  double lower;
  double upper;
};

/// A formula of some coefficients as the fit sees it: all that it knows of a form.
class SkyFormula {
 public:
  virtual ~SkyFormula() = default;

  /// One per coefficient.
  virtual std::vector<CoefficientBounds> bounds() const = 0;

  /// Coefficients from which to search, one set each.
  virtual std::vector<std::vector<double>> starts() const = 0;

  /// Coefficients of which the value is a linear combination, given the others: the fit solves for them at
  /// every start. None: nothing is eliminated.
  virtual std::vector<std::size_t> linear() const { return {}; }

  /// @param gradient  by the coefficients, filled; empty: not wanted
  virtual double value(std::span<const double> coefficients, const FormulaView& view,
                       std::span<double> gradient) const = 0;
};

/// F(θ,γ)/F(0,θ_s) of Perez's formula. [fit.md F1-F2]
class PerezRatio final : public SkyFormula {
 public:
  std::vector<CoefficientBounds> bounds() const override;
  std::vector<std::vector<double>> starts() const override;
  double value(std::span<const double> coefficients, const FormulaView& view,
               std::span<double> gradient) const override;
};

/// Hosek and Wilkie's formula. [models.md]
class HosekWilkieFormula final : public SkyFormula {
 public:
  std::vector<CoefficientBounds> bounds() const override;
  std::vector<std::vector<double>> starts() const override;
  std::vector<std::size_t> linear() const override { return {2, 3, 5, 6, 8}; }
  double value(std::span<const double> coefficients, const FormulaView& view,
               std::span<double> gradient) const override;
};

}  // namespace skylut::forms_detail
