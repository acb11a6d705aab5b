#include "spherical/angular_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "skylut/core/constants.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut::transfer {
namespace {

double entry(const PanelMatrix& matrix, int row, int column) {
  constexpr int kPanelRows = 5;  // of apply_matrix
  return matrix.data()[(row / kPanelRows * matrix.columns() + column) * kPanelRows + row % kPanelRows];
}

/// Entry of an azimuthal matrix for any node: the first half of the nodes and their mirror images.
double azimuthal(const PanelMatrix& matrix, bool synthesis, int k, int m, int nodes) {
  const bool mirrored = k >= nodes / 2;
  const int node = mirrored ? nodes - 1 - k : k;
  const double sign = mirrored && m % 2 == 1 ? -1.0 : 1.0;
  return sign * (synthesis ? entry(matrix, node, m / 2) : entry(matrix, m / 2, node));
}

// ∫ Λ_lm Λ_km dμ = 2/(2l+1) δ_lk. The n-point rule in t = √|μ| is exact for degree 2n - 1 in t. Even l + k
// with the weight 2t: degree 2(l+k) + 1 <= 2n - 1. For odd l + k the hemispheres cancel.
TEST(AngularGrid, QuadratureKeepsTheLegendreFunctionsOrthogonal) {
  const AngularGrid grid({12, 9, 14, 10});
  const int nodes = grid.polar_nodes();
  for (int m = 0; m <= 9; ++m)
    for (int l = m; l <= 12; ++l)
      for (int k = m; k <= 12; ++k) {
        if (l + k > nodes - 1) continue;
        double integral = 0.0;
        for (int j = 0; j < nodes; ++j)
          for (const double side : {-1.0, 1.0}) {
            const auto node = static_cast<std::size_t>(j);
            const std::vector<double> lambda = normalised_legendre(m, 12, side * grid.cos_polar()[node]);
            integral += grid.polar_weight()[node] * lambda[static_cast<std::size_t>(l - m)] *
                        lambda[static_cast<std::size_t>(k - m)];
          }
        EXPECT_NEAR(integral, l == k ? 2.0 / (2.0 * l + 1.0) : 0.0, 1e-12) << l << " " << k << " " << m;
      }
}

TEST(AngularGrid, WeightsIntegrateSimpleFields) {
  for (const int nodes : {8, 10, 16}) {
    const AngularGrid grid({8, 6, nodes, 8});
    double solid_angle = 0.0;
    double flux = 0.0;
    for (std::size_t j = 0; j < grid.cos_polar().size(); ++j) {
      solid_angle += 2.0 * kPi * grid.polar_weight()[j];
      flux += 2.0 * kPi * grid.polar_weight()[j] * grid.cos_polar()[j];
    }
    // A uniform hemisphere of radiance 1: exact by the rule, so rounding only.
    EXPECT_NEAR(solid_angle, 2.0 * kPi, 1e-13);
    EXPECT_NEAR(flux, kPi, 1e-13);
  }
}

/// Moments -> radiance of both hemispheres -> moments, with the matrices of the sweep.
std::vector<double> round_trip(const AngularGrid& grid, const std::vector<double>& moment) {
  std::vector<double> back(moment.size());
  for (const Hemisphere hemisphere : {kDown, kUp})
    for (int j = 0; j < grid.polar_nodes(); ++j)
      for (int k = 0; k < grid.azimuth_nodes(); ++k) {
        double radiance = 0.0;
        for (int m = 0; m < grid.azimuthal_orders(); ++m)
          for (int i = 0; i < grid.legendre_terms(m); ++i)
            radiance += (2.0 * (m + i) + 1.0) * entry(grid.polar_synthesis(hemisphere, m), j, i) *
                        azimuthal(grid.azimuth_synthesis(m % 2), true, k, m, grid.azimuth_nodes()) *
                        moment[static_cast<std::size_t>(grid.moment_offset(m) + i)];
        for (int m = 0; m < grid.azimuthal_orders(); ++m)
          for (int i = 0; i < grid.legendre_terms(m); ++i)
            back[static_cast<std::size_t>(grid.moment_offset(m) + i)] +=
                entry(grid.polar_analysis(hemisphere, m), i, j) *
                azimuthal(grid.azimuth_analysis(m % 2), false, k, m, grid.azimuth_nodes()) * radiance;
      }
  return back;
}

// A field of degree <= 6 is found again by its moments: I = Σ (2l+1)(2-δ_m0) Λ_lm cos(mφ) M_lm.
TEST(AngularGrid, BandLimitedFieldsSurviveTheRoundTrip) {
  const AngularGrid grid({6, 5, 14, 6});
  std::vector<double> moment;
  for (int i = 0; i < grid.moments(); ++i) moment.push_back(std::cos(1.7 * i) / (1.0 + 0.2 * i));
  const std::vector<double> back = round_trip(grid, moment);
  // Single-precision matrices: the 168 terms of each sum, of size 1, round to 6e-8.
  for (std::size_t i = 0; i < moment.size(); ++i) EXPECT_NEAR(back[i], moment[i], 2e-6) << i;
}

// The zeroth moment of a uniform field is that field: (1/4π)∫ I dΩ, half of it from each hemisphere.
TEST(AngularGrid, MeanOfAUniformField) {
  const AngularGrid grid({4, 3, 8, 4});
  for (const Hemisphere hemisphere : {kDown, kUp}) {
    double mean = 0.0;
    for (int j = 0; j < grid.polar_nodes(); ++j)
      mean += grid.azimuth_nodes() * entry(grid.polar_analysis(hemisphere, 0), 0, j);
    EXPECT_NEAR(mean, 0.5, 1e-7);
  }
}

}  // namespace
}  // namespace skylut::transfer
