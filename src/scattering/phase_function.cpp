#include "skylut/scattering/phase_function.hpp"

#include <cmath>
#include <utility>

#include "skylut/core/errors.hpp"
#include "skylut/core/generalised_legendre.hpp"
#include "skylut/core/legendre.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {

ScatteringMatrix PhaseFunction::matrix(double cos_scattering_angle) const {
  const double f11 = value(cos_scattering_angle);
  const double kept = 0.25 * (1.0 + cos_scattering_angle) * (1.0 + cos_scattering_angle) * f11;
  return {.f11 = f11, .f12 = 0.0, .f22 = kept, .f33 = kept};
}

std::vector<MatrixMoments> PhaseFunction::matrix_moments(int max_l) const {
  std::vector<MatrixMoments> moments(static_cast<std::size_t>(max_l + 1));
  // μ = 1 - 2t⁴ crowds the nodes in the forward peak: ½ dμ = 4t³ dt.
  constexpr int kNodes = 200;
  const Quadrature rule = gauss_legendre(kNodes + max_l, 0.0, 1.0);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double cube = rule.node[i] * rule.node[i] * rule.node[i];
    const double mu = 1.0 - 2.0 * cube * rule.node[i];
    const double weight = 4.0 * cube * rule.weight[i];
    const ScatteringMatrix at = matrix(mu);
    const std::vector<double> polarising = generalised_legendre(0, 2, max_l, mu);
    const std::vector<double> same = generalised_legendre(2, 2, max_l, mu);
    const std::vector<double> opposite = generalised_legendre(2, -2, max_l, mu);
    for (std::size_t l = 2; l < moments.size(); ++l) {
      const double sum = weight * (at.f22 + at.f33) * same[l - 2];
      const double difference = weight * (at.f22 - at.f33) * opposite[l - 2];
      moments[l].alpha2 += 0.5 * (sum + difference);
      moments[l].alpha3 += 0.5 * (sum - difference);
      moments[l].beta1 += weight * at.f12 * polarising[l - 2];
    }
  }
  for (int l = 0; l <= max_l; ++l) moments[static_cast<std::size_t>(l)].alpha1 = moment(l);
  return moments;
}

RayleighPhaseFunction::RayleighPhaseFunction(double depolarisation)
    : gamma_(depolarisation / (2.0 - depolarisation)) {
  if (!(depolarisation >= 0.0 && depolarisation <= 0.5))
    throw InputError("depolarisation {}: must lie within 0-0.5", depolarisation);
}

double RayleighPhaseFunction::value(double cos_scattering_angle) const {
  return 0.75 * (1.0 + 3.0 * gamma_ + (1.0 - gamma_) * cos_scattering_angle * cos_scattering_angle) /
         (1.0 + 2.0 * gamma_);
}

double RayleighPhaseFunction::moment(int l) const {
  if (l == 0) return 1.0;
  return l == 2 ? 0.1 * (1.0 - gamma_) / (1.0 + 2.0 * gamma_) : 0.0;
}

ScatteringMatrix RayleighPhaseFunction::matrix(double cos_scattering_angle) const {
  const double dipole = (1.0 - gamma_) / (1.0 + 2.0 * gamma_);  // Δ
  const double square = cos_scattering_angle * cos_scattering_angle;
  return {.f11 = value(cos_scattering_angle),
          .f12 = -0.75 * dipole * (1.0 - square),
          .f22 = 0.75 * dipole * (1.0 + square),
          .f33 = 1.5 * dipole * cos_scattering_angle};
}

std::vector<MatrixMoments> RayleighPhaseFunction::matrix_moments(int max_l) const {
  std::vector<MatrixMoments> moments(static_cast<std::size_t>(max_l + 1));
  const double dipole = (1.0 - gamma_) / (1.0 + 2.0 * gamma_);
  moments[0].alpha1 = 1.0;
  if (max_l >= 2)
    moments[2] = {.alpha1 = 0.1 * dipole,
                  .alpha2 = 0.6 * dipole,
                  .alpha3 = 0.0,
                  .beta1 = -0.1 * std::sqrt(6.0) * dipole};
  return moments;
}

HenyeyGreensteinPhaseFunction::HenyeyGreensteinPhaseFunction(double asymmetry) : asymmetry_(asymmetry) {
  if (!(std::abs(asymmetry) < 1.0)) throw InputError("asymmetry {}: must lie between -1 and 1", asymmetry);
}

double HenyeyGreensteinPhaseFunction::value(double cos_scattering_angle) const {
  const double square = asymmetry_ * asymmetry_;
  const double base = 1.0 + square - 2.0 * asymmetry_ * cos_scattering_angle;
  return (1.0 - square) / (base * std::sqrt(base));
}

double HenyeyGreensteinPhaseFunction::moment(int l) const { return std::pow(asymmetry_, l); }

LegendrePhaseFunction::LegendrePhaseFunction(std::vector<double> moments) : moments_(std::move(moments)) {
  if (moments_.empty() || std::abs(moments_[0] - 1.0) > 1e-6)
    throw InputError("phase function moments: the first must be 1");
  for (std::size_t l = 0; l < moments_.size(); ++l)
    if (!(std::abs(moments_[l]) <= 1.0 + 1e-9))
      throw InputError("phase function moment {} of order {}: must lie within -1 to 1", moments_[l], l);
}

double LegendrePhaseFunction::value(double cos_scattering_angle) const {
  double previous = 0.0;
  double legendre = 1.0;
  double sum = moments_[0];
  for (std::size_t l = 1; l < moments_.size(); ++l) {
    const auto order = static_cast<double>(l);
    const double next = next_legendre(1.0 / order, cos_scattering_angle, legendre, previous);
    previous = legendre;
    legendre = next;
    sum += (2.0 * order + 1.0) * moments_[l] * legendre;
  }
  return sum;
}

double LegendrePhaseFunction::moment(int l) const {
  const auto order = static_cast<std::size_t>(l);
  return order < moments_.size() ? moments_[order] : 0.0;
}

}  // namespace skylut
