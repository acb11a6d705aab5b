#include "skylut/scattering/phase_function.hpp"

#include <cmath>
#include <utility>

#include "skylut/core/errors.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut {

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
