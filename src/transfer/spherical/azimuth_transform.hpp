#pragma once

#include "kernel_problem.hpp"
#include "lanes.hpp"

// Between the azimuth nodes of one polar angle and azimuthal orders. As in lanes.hpp, templates only. The
// nodes mirror each other about π/2, where cos mφ is even for even m and odd for odd m, so that each parity
// needs half of them. [theory.md §4.3, M1-M2]

namespace skylut::transfer {

/// Σ_m (2-δ_m0) order_m cos mφ at the azimuth nodes: even and odd m on half of the nodes, which mirror each
/// other about π/2.
template <class V>
inline void azimuths_of_orders(const SweepView& grid, const V* order, V* azimuth) {
  const int nodes = grid.azimuth_nodes;
  V even[kMostAzimuths / 2];
  V odd[kMostAzimuths / 2];
  apply_matrix(grid.azimuth_synthesis[0], nodes / 2, (grid.azimuthal_orders + 1) / 2, order, 2, even, 1);
  apply_matrix(grid.azimuth_synthesis[1], nodes / 2, grid.azimuthal_orders / 2, order + 1, 2, odd, 1);
  for (int k = 0; k < nodes / 2; ++k) {
    azimuth[k] = even[k] + odd[k];
    azimuth[nodes - 1 - k] = even[k] - odd[k];
  }
}

/// Σ_k radiance_k cos mφ_k for every m, the same way back.
template <class V>
inline void orders_of_azimuths(const SweepView& grid, const V* azimuth, V* order) {
  const int nodes = grid.azimuth_nodes;
  V even[kMostAzimuths / 2];
  V odd[kMostAzimuths / 2];
  for (int k = 0; k < nodes / 2; ++k) {
    even[k] = azimuth[k] + azimuth[nodes - 1 - k];
    odd[k] = azimuth[k] - azimuth[nodes - 1 - k];
  }
  apply_matrix(grid.azimuth_analysis[0], (grid.azimuthal_orders + 1) / 2, nodes / 2, even, 1, order, 2);
  apply_matrix(grid.azimuth_analysis[1], grid.azimuthal_orders / 2, nodes / 2, odd, 1, order + 1, 2);
}

}  // namespace skylut::transfer
