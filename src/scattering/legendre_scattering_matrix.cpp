#include "skylut/scattering/legendre_scattering_matrix.hpp"

#include <cmath>
#include <utility>

#include "skylut/core/errors.hpp"
#include "skylut/core/generalised_legendre.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut {

namespace {

void check(const char* name, double value, std::size_t l) {
  if (!(std::abs(value) <= 1.0 + 1e-9))
    throw InputError("scattering matrix: {} {} of degree {} must lie within -1 to 1", name, value, l);
}

}  // namespace

LegendreScatteringMatrix::LegendreScatteringMatrix(std::vector<MatrixMoments> moments)
    : moments_(std::move(moments)) {
  if (moments_.empty() || !(std::abs(moments_[0].alpha1 - 1.0) <= 1e-6))
    throw InputError("scattering matrix: the first of alpha1 must be 1");
  for (std::size_t l = 0; l < moments_.size(); ++l) {
    MatrixMoments& moment = moments_[l];
    check("alpha1", moment.alpha1, l);
    if (l < 2) moment = {.alpha1 = moment.alpha1};
    check("alpha2", moment.alpha2, l);
    check("alpha3", moment.alpha3, l);
    check("beta1", moment.beta1, l);
  }
}

double LegendreScatteringMatrix::value(double cos_scattering_angle) const {
  double previous = 0.0;
  double legendre = 1.0;
  double sum = moments_[0].alpha1;
  for (std::size_t l = 1; l < moments_.size(); ++l) {
    const auto order = static_cast<double>(l);
    const double next = next_legendre(1.0 / order, cos_scattering_angle, legendre, previous);
    previous = legendre;
    legendre = next;
    sum += (2.0 * order + 1.0) * moments_[l].alpha1 * legendre;
  }
  return sum;
}

double LegendreScatteringMatrix::moment(int l) const {
  const auto order = static_cast<std::size_t>(l);
  return order < moments_.size() ? moments_[order].alpha1 : 0.0;
}

ScatteringMatrix LegendreScatteringMatrix::matrix(double cos_scattering_angle) const {
  const int last = static_cast<int>(moments_.size()) - 1;
  const std::vector<double> polarising = generalised_legendre(0, 2, last, cos_scattering_angle);
  const std::vector<double> same = generalised_legendre(2, 2, last, cos_scattering_angle);
  const std::vector<double> opposite = generalised_legendre(2, -2, last, cos_scattering_angle);
  double f12 = 0.0;
  double sum = 0.0;
  double difference = 0.0;
  for (std::size_t l = 2; l < moments_.size(); ++l) {
    const double weight = 2.0 * static_cast<double>(l) + 1.0;
    f12 += weight * moments_[l].beta1 * polarising[l - 2];
    sum += weight * (moments_[l].alpha2 + moments_[l].alpha3) * same[l - 2];
    difference += weight * (moments_[l].alpha2 - moments_[l].alpha3) * opposite[l - 2];
  }
  return {value(cos_scattering_angle), f12, 0.5 * (sum + difference), 0.5 * (sum - difference)};
}

std::vector<MatrixMoments> LegendreScatteringMatrix::matrix_moments(int max_l) const {
  std::vector<MatrixMoments> moments = moments_;
  moments.resize(static_cast<std::size_t>(max_l + 1));
  return moments;
}

}  // namespace skylut
