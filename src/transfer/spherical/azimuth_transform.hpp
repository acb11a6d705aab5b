#pragma once

#include "angular_sizes.hpp"
#include "kernel_problem.hpp"

// Between the azimuth nodes of one polar angle and azimuthal orders. As in lanes.hpp, templates only. The
// nodes mirror each other about π/2, where cos mφ is even for even m and odd for odd m, so that each parity
// needs half of them. [theory.md §4.3, M1-M2]

namespace skylut::transfer {

/// From the orders of one parity to the first half of the azimuth nodes.
template <class V, class Sizes, int kParity>
inline void halves_of_parity(const Sizes& sizes, Constant<kParity>, const float* panels, const V* order,
                             V* half) {
  if constexpr (Sizes::kFixed)
    apply_fixed_matrix<V, Sizes::azimuth_nodes / 2, (Sizes::azimuthal_orders + 1 - kParity) / 2>(
        panels, order, 2, half, 1);
  else
    apply_matrix(panels, sizes.azimuth_nodes / 2, (sizes.azimuthal_orders + 1 - kParity) / 2, order, 2, half,
                 1);
}

/// And back.
template <class V, class Sizes, int kParity>
inline void parity_of_halves(const Sizes& sizes, Constant<kParity>, const float* panels, const V* half,
                             V* order) {
  if constexpr (Sizes::kFixed)
    apply_fixed_matrix<V, (Sizes::azimuthal_orders + 1 - kParity) / 2, Sizes::azimuth_nodes / 2>(panels, half,
                                                                                                 1, order, 2);
  else
    apply_matrix(panels, (sizes.azimuthal_orders + 1 - kParity) / 2, sizes.azimuth_nodes / 2, half, 1, order,
                 2);
}

/// Σ_m (2-δ_m0) order_m cos mφ at the azimuth nodes: even and odd m on half of the nodes, which mirror each
/// other about π/2.
template <class V, class Sizes>
inline void azimuths_of_orders(const SweepView& grid, const Sizes& sizes, const V* order, V* azimuth) {
  const int nodes = sizes.azimuth_nodes;
  V even[kMostAzimuths / 2];
  V odd[kMostAzimuths / 2];
  halves_of_parity(sizes, Constant<0>{}, grid.azimuth_synthesis[0], order, even);
  halves_of_parity(sizes, Constant<1>{}, grid.azimuth_synthesis[1], order + 1, odd);
  for (int k = 0; k < nodes / 2; ++k) {
    azimuth[k] = even[k] + odd[k];
    azimuth[nodes - 1 - k] = even[k] - odd[k];
  }
}

/// Σ_k radiance_k cos mφ_k for every m, the same way back.
template <class V, class Sizes>
inline void orders_of_azimuths(const SweepView& grid, const Sizes& sizes, const V* azimuth, V* order) {
  const int nodes = sizes.azimuth_nodes;
  V even[kMostAzimuths / 2];
  V odd[kMostAzimuths / 2];
  for (int k = 0; k < nodes / 2; ++k) {
    even[k] = azimuth[k] + azimuth[nodes - 1 - k];
    odd[k] = azimuth[k] - azimuth[nodes - 1 - k];
  }
  parity_of_halves(sizes, Constant<0>{}, grid.azimuth_analysis[0], even, order);
  parity_of_halves(sizes, Constant<1>{}, grid.azimuth_analysis[1], odd, order + 1);
}

}  // namespace skylut::transfer
