#include "angular_grid.hpp"

#include <cmath>

#include "lanes.hpp"
#include "skylut/core/check.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

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
  SKYLUT_CHECK_LE(azimuths, kMostAzimuths);
  SKYLUT_CHECK(azimuths % 2 == 0);

  const Quadrature rule = gauss_legendre(nodes, 0.0, 1.0);
  for (std::size_t j = 0; j < rule.node.size(); ++j) {
    cos_polar_.push_back(rule.node[j] * rule.node[j]);
    polar_weight_.push_back(2.0 * rule.node[j] * rule.weight[j]);
  }
  for (int k = 0; k < azimuths; ++k) azimuth_rad_.push_back((k + 0.5) * kPi / azimuths);

  moment_offset_.push_back(0);
  for (int m = 0; m < orders; ++m) moment_offset_.push_back(moment_offset_.back() + legendre_terms(m));

  for (int parity = 0; parity < 2; ++parity) {
    const int count = (orders + 1 - parity) / 2;
    azimuth_synthesis_[static_cast<std::size_t>(parity)] = PanelMatrix(azimuths / 2, count);
    azimuth_analysis_[static_cast<std::size_t>(parity)] = PanelMatrix(count, azimuths / 2);
  }
  for (int m = 0; m < orders; ++m) {
    for (const Hemisphere hemisphere : {kDown, kUp}) {
      PanelMatrix synthesis(nodes, legendre_terms(m));
      PanelMatrix analysis(legendre_terms(m), nodes);
      for (int j = 0; j < nodes; ++j) {
        const auto node = static_cast<std::size_t>(j);
        const double mu = hemisphere == kUp ? cos_polar_[node] : -cos_polar_[node];
        const std::vector<double> lambda = normalised_legendre(m, resolution.max_l, mu);
        // (1/4π) × 2 (both halves of the azimuth circle) × π/K per midpoint.
        const double weight = 0.5 * polar_weight_[node] / azimuths;
        for (int i = 0; i < legendre_terms(m); ++i) {
          synthesis.set(j, i, lambda[static_cast<std::size_t>(i)]);
          analysis.set(i, j, weight * lambda[static_cast<std::size_t>(i)]);
        }
      }
      polar_synthesis_[hemisphere].push_back(std::move(synthesis));
      polar_analysis_[hemisphere].push_back(std::move(analysis));
    }
    const auto parity = static_cast<std::size_t>(m % 2);
    for (int k = 0; k < azimuths / 2; ++k) {
      const double cosine = std::cos(m * azimuth_rad_[static_cast<std::size_t>(k)]);
      azimuth_synthesis_[parity].set(k, m / 2, m == 0 ? cosine : 2.0 * cosine);
      azimuth_analysis_[parity].set(m / 2, k, cosine);
    }
  }
}

}  // namespace skylut::transfer
