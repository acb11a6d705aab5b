#include "angular_grid.hpp"

#include <cmath>

#include "lanes.hpp"
#include "skylut/core/constants.hpp"

namespace skylut::transfer {

std::vector<double> normalised_legendre(int m, int max_l, double mu) {
  std::vector<double> lambda(static_cast<std::size_t>(max_l - m + 1));
  // Λ_mm = √((2m)!)/(2^m m!) (1-μ²)^{m/2}, then the three-term recurrence in l
  // (Abramowitz & Stegun 8.5.3 with the normalisation divided out).
  const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
  double previous = 0.0;
  double current = 1.0;
  for (int k = 1; k <= m; ++k) current *= sine * std::sqrt((2.0 * k - 1.0) / (2.0 * k));
  lambda[0] = current;
  for (int l = m + 1; l <= max_l; ++l) {
    const double below = std::sqrt(static_cast<double>((l - 1) * (l - 1) - m * m));
    const double here = std::sqrt(static_cast<double>(l * l - m * m));
    const double next = ((2.0 * l - 1.0) * mu * current - below * previous) / here;
    previous = current;
    current = next;
    lambda[static_cast<std::size_t>(l - m)] = current;
  }
  return lambda;
}

PanelMatrix::PanelMatrix(int rows, int columns)
    : rows_(rows),
      columns_(columns),
      data_(static_cast<std::size_t>((rows + kPanel - 1) / kPanel * kPanel * columns)) {}

void PanelMatrix::set(int row, int column, double value) {
  const int at = (row / kPanel * columns_ + column) * kPanel + row % kPanel;
  data_[static_cast<std::size_t>(at)] = static_cast<float>(value);
}

AngularGrid::AngularGrid(const AngularResolution& resolution) : resolution_(resolution) {
  const int nodes = resolution.polar_nodes;
  const int azimuths = resolution.azimuth_nodes;
  const int orders = resolution.max_m + 1;

  const Quadrature rule = gauss_legendre(nodes, 0.0, 1.0);
  for (std::size_t j = 0; j < rule.node.size(); ++j) {
    cos_polar_.push_back(rule.node[j] * rule.node[j]);
    polar_weight_.push_back(2.0 * rule.node[j] * rule.weight[j]);
  }
  for (int k = 0; k < azimuths; ++k) azimuth_rad_.push_back((k + 0.5) * kPi / azimuths);

  moment_offset_.push_back(0);
  for (int m = 0; m < orders; ++m) moment_offset_.push_back(moment_offset_.back() + degrees(m));

  azimuth_synthesis_ = PanelMatrix(azimuths, orders);
  azimuth_analysis_ = PanelMatrix(orders, azimuths);
  for (int m = 0; m < orders; ++m) {
    for (const Hemisphere half : {kDown, kUp}) {
      PanelMatrix synthesis(nodes, degrees(m));
      PanelMatrix analysis(degrees(m), nodes);
      for (int j = 0; j < nodes; ++j) {
        const auto node = static_cast<std::size_t>(j);
        const double mu = half == kUp ? cos_polar_[node] : -cos_polar_[node];
        const std::vector<double> lambda = normalised_legendre(m, resolution.max_l, mu);
        // (1/4π) × 2 (both halves of the azimuth circle) × π/K per midpoint.
        const double weight = 0.5 * polar_weight_[node] / azimuths;
        for (int i = 0; i < degrees(m); ++i) {
          synthesis.set(j, i, lambda[static_cast<std::size_t>(i)]);
          analysis.set(i, j, weight * lambda[static_cast<std::size_t>(i)]);
        }
      }
      polar_synthesis_[half].push_back(std::move(synthesis));
      polar_analysis_[half].push_back(std::move(analysis));
    }
    for (int k = 0; k < azimuths; ++k) {
      const double cosine = std::cos(m * azimuth_rad_[static_cast<std::size_t>(k)]);
      azimuth_synthesis_.set(k, m, m == 0 ? cosine : 2.0 * cosine);
      azimuth_analysis_.set(m, k, cosine);
    }
  }
}

}  // namespace skylut::transfer
