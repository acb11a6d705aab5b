#include "polarised_angles.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/check.hpp"
#include "skylut/core/generalised_legendre.hpp"

namespace skylut::transfer {

namespace {

constexpr int kLeastDegree = 2;  // Q and U have none below

int least_degree(int m) { return std::max(m, kLeastDegree); }

/// The functions that Q + U (0) and Q - U (1) go by.
std::vector<double> polarised_functions(int combination, int m, int degree, double mu) {
  if (combination == 0) return generalised_legendre(m, -2, degree, mu);
  std::vector<double> d = generalised_legendre(m, 2, degree, mu);
  if (m == 1)
    for (double& value : d) value = -value;
  return d;
}

}  // namespace

void PolarisedAngles::Matrices::add(PanelMatrix matrix) { own.push_back(std::move(matrix)); }

void PolarisedAngles::Matrices::point() {
  for (const PanelMatrix& matrix : own) data.push_back(matrix.data());
}

PolarisedAngles::PolarisedAngles(const AngularGrid& angles, int degree)
    : degree_(degree), orders_(std::min(degree, angles.resolution().max_m) + 1) {
  SKYLUT_CHECK_GE(degree, kLeastDegree);
  SKYLUT_CHECK_LE(degree, angles.resolution().max_l);
  const int nodes = angles.polar_nodes();
  const int azimuths = angles.azimuth_nodes();
  for (int m = 0; m < orders_; ++m) {
    moment_offset_.push_back(moments());
    for (int l = least_degree(m); l <= degree; ++l) {
      moment_degree_.push_back(l);
      moment_of_intensity_.push_back(angles.moment_offset(m) + l - m);
    }
    const int terms = degree + 1 - least_degree(m);
    for (const Hemisphere hemisphere : {kDown, kUp})
      for (const std::size_t combination : {0U, 1U}) {
        PanelMatrix synthesis(nodes, terms);
        PanelMatrix analysis(terms, nodes);
        for (int j = 0; j < nodes; ++j) {
          const auto node = static_cast<std::size_t>(j);
          const double mu = hemisphere == kUp ? angles.cos_polar()[node] : -angles.cos_polar()[node];
          const std::vector<double> d = polarised_functions(static_cast<int>(combination), m, degree, mu);
          const double weight = 0.5 * angles.polar_weight()[node] / azimuths;  // as AngularGrid's
          for (int i = 0; i < terms; ++i) {
            synthesis.set(j, i, 0.5 * d[static_cast<std::size_t>(i)]);
            analysis.set(i, j, 0.5 * weight * d[static_cast<std::size_t>(i)]);
          }
        }
        polar_synthesis_[hemisphere][combination].add(std::move(synthesis));
        polar_analysis_[hemisphere][combination].add(std::move(analysis));
      }
  }
  moment_offset_.push_back(moments());
  for (const Hemisphere hemisphere : {kDown, kUp})
    for (const std::size_t combination : {0U, 1U}) {
      polar_synthesis_[hemisphere][combination].point();
      polar_analysis_[hemisphere][combination].point();
    }

  for (int parity = 0; parity < 2; ++parity) {
    const auto of = static_cast<std::size_t>(parity);
    const int count = (orders_ + 1 - parity) / 2;
    cosine_synthesis_[of] = PanelMatrix(azimuths / 2, count);
    cosine_analysis_[of] = PanelMatrix(count, azimuths / 2);
    sine_synthesis_[of] = PanelMatrix(azimuths / 2, count);
    sine_analysis_[of] = PanelMatrix(count, azimuths / 2);
    for (int m = parity; m < orders_; m += 2)
      for (int k = 0; k < azimuths / 2; ++k) {
        const double angle = m * angles.azimuth_rad()[static_cast<std::size_t>(k)];
        const double factor = m == 0 ? 1.0 : 2.0;
        cosine_synthesis_[of].set(k, m / 2, factor * std::cos(angle));
        cosine_analysis_[of].set(m / 2, k, std::cos(angle));
        sine_synthesis_[of].set(k, m / 2, factor * std::sin(angle));
        sine_analysis_[of].set(m / 2, k, std::sin(angle));
      }
  }
}

PolarisedView PolarisedAngles::view() const {
  PolarisedView view{};
  view.moments = moments();
  view.orders = orders_;
  view.degrees = degree_ + 1;
  view.moment_offset = moment_offset_.data();
  view.moment_degree = moment_degree_.data();
  view.moment_of_intensity = moment_of_intensity_.data();
  for (const int hemisphere : {0, 1})
    for (const int combination : {0, 1}) {
      const auto h = static_cast<std::size_t>(hemisphere);
      const auto c = static_cast<std::size_t>(combination);
      view.polar_synthesis[hemisphere][combination] = polar_synthesis_[h][c].data.data();
      view.polar_analysis[hemisphere][combination] = polar_analysis_[h][c].data.data();
    }
  for (const int parity : {0, 1}) {
    const auto of = static_cast<std::size_t>(parity);
    view.cosine_synthesis[parity] = cosine_synthesis_[of].data();
    view.cosine_analysis[parity] = cosine_analysis_[of].data();
    view.sine_synthesis[parity] = sine_synthesis_[of].data();
    view.sine_analysis[parity] = sine_analysis_[of].data();
  }
  return view;
}

void PolarisedAngles::rotation_functions(double mu, std::vector<float>& r, std::vector<float>& t) const {
  for (int m = 0; m < orders_; ++m) {
    const std::vector<double> plus = polarised_functions(0, m, degree_, mu);
    const std::vector<double> minus = polarised_functions(1, m, degree_, mu);
    for (std::size_t i = 0; i < plus.size(); ++i) {
      r.push_back(static_cast<float>(0.5 * (minus[i] + plus[i])));
      t.push_back(static_cast<float>(0.5 * (minus[i] - plus[i])));
    }
  }
}

}  // namespace skylut::transfer
