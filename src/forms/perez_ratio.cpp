#include <array>
#include <cmath>
#include <limits>

#include "sky_formula.hpp"
#include "skylut/models/preetham_coefficients.hpp"

namespace skylut::forms_detail {

namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

// F and its derivatives by A to E.
double perez_with_gradient(std::span<const double> c, double cos_zenith, double gamma_rad, double cos_gamma,
                           std::array<double, 5>& gradient) {
  constexpr double kHorizon = 1e-12;
  const double secant = cos_zenith > kHorizon ? 1.0 / cos_zenith : kFree;
  const double fade = std::isinf(secant) ? 0.0 : std::exp(c[1] * secant);
  const double aureole = std::exp(c[3] * gamma_rad);
  const double gradation = 1.0 + c[0] * fade;
  const double indicatrix = 1.0 + c[2] * aureole + c[4] * cos_gamma * cos_gamma;
  gradient = {fade * indicatrix, fade == 0.0 ? 0.0 : c[0] * secant * fade * indicatrix, gradation * aureole,
              gradation * c[2] * gamma_rad * aureole, gradation * cos_gamma * cos_gamma};
  return gradation * indicatrix;
}

}  // namespace

std::vector<CoefficientBounds> PerezRatio::bounds() const {
  // Finite at the horizon, every exponential within 32-bit floats. A, C and E grow together without end along
  // the poles of the ratio, and change the sky less and less.
  return {{-20.0, 20.0}, {-80.0, -1e-3}, {-20.0, 20.0}, {-80.0, 25.0}, {-20.0, 20.0}};
}

std::vector<std::vector<double>> PerezRatio::starts() const {
  std::vector<std::vector<double>> starts;
  const auto add = [&starts](const PerezCoefficients& k) { starts.push_back({k.A, k.B, k.C, k.D, k.E}); };
  const PerezYxy published = preetham1999_coefficients(3.0);
  add(published.Y);
  add(published.x);
  add(published.y);
  for (const double A : {-0.9, 0.5, 4.0})
    for (const double B : {-0.15, -0.7, -3.0})
      for (const double D : {-1.0, -4.0, -10.0})
        for (const double C : {0.3, 8.0}) add({A, B, C, D, 0.2});
  return starts;
}

double PerezRatio::value(std::span<const double> c, const FormulaView& view,
                         std::span<double> gradient) const {
  std::array<double, 5> above{};
  std::array<double, 5> below{};
  const double numerator = perez_with_gradient(c, view.cos_zenith, view.gamma_rad, view.cos_gamma, above);
  const double denominator =
      perez_with_gradient(c, 1.0, view.sun_zenith_rad, std::cos(view.sun_zenith_rad), below);
  const double ratio = numerator / denominator;
  for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] = (above[i] - ratio * below[i]) / denominator;
  return ratio;
}

}  // namespace skylut::forms_detail
