#include <cmath>
#include <limits>

#include "sky_formula.hpp"
#include "skylut/models/hosek_wilkie.hpp"

namespace skylut::forms_detail {

namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();
constexpr std::size_t A = 0, B = 1, C = 2, D = 3, E = 4, F = 5, G = 6, H = 7, I = 8;

}  // namespace

std::vector<CoefficientBounds> HosekWilkieFormula::bounds() const {
  // B < 0 and cosθ + 0.01 keep the gradation finite; H below 1 the peak of χ. E reaches aureoles 2° wide and
  // the ring opposite the sun.
  return {{-kFree, kFree}, {-20.0, -1e-3},  {-kFree, kFree}, {-kFree, kFree}, {-30.0, 4.0},
          {-kFree, kFree}, {-kFree, kFree}, {0.0, 0.99},     {-kFree, kFree}};
}

std::vector<std::vector<double>> HosekWilkieFormula::starts() const {
  std::vector<std::vector<double>> starts;
  for (const double a : {-1.0, 0.5, 3.0})
    for (const double b : {-0.1, -0.35, -1.0})
      for (const double e : {-1.0, -3.0, -8.0})
        for (const double h : {0.4, 0.7, 0.9}) starts.push_back({a, b, 1.0, 1.0, e, 0.1, 0.1, h, 0.1});
  return starts;
}

double HosekWilkieFormula::value(std::span<const double> c, const FormulaView& view,
                                 std::span<double> gradient) const {
  if (gradient.empty()) return hosek_wilkie(c.first<9>(), view.cos_zenith, view.gamma_rad, view.cos_gamma);
  const double height = std::fmax(view.cos_zenith, 0.0);
  const double fade = std::exp(c[B] / (height + 0.01));
  const double gradation = 1.0 + c[A] * fade;
  const double aureole = std::exp(c[E] * view.gamma_rad);
  const double chi = anisotropic_term(c[H], view.cos_gamma);
  const double root = std::sqrt(height);
  const double cos2 = view.cos_gamma * view.cos_gamma;
  const double indicatrix = c[C] + c[D] * aureole + c[F] * cos2 + c[G] * chi + c[I] * root;
  gradient[A] = fade * indicatrix;
  gradient[B] = c[A] * fade / (height + 0.01) * indicatrix;
  gradient[C] = gradation;
  gradient[D] = gradation * aureole;
  gradient[E] = gradation * c[D] * view.gamma_rad * aureole;
  gradient[F] = gradation * cos2;
  gradient[G] = gradation * chi;
  // d ln χ / dH = -3 (H - cosγ) / (1 + H² - 2 H cosγ)
  gradient[H] = gradation * c[G] * chi * -3.0 * (c[H] - view.cos_gamma) /
                (1.0 + c[H] * c[H] - 2.0 * c[H] * view.cos_gamma);
  gradient[I] = gradation * root;
  return gradation * indicatrix;
}

}  // namespace skylut::forms_detail
