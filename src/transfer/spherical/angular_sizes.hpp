#pragma once

#include "angular_grid.hpp"
#include "lanes.hpp"

// Sizes of the angular transforms. The sweep spends its time in small matrix products, whose loops are worth
// being unrolled: for the shapes that columns of air take at the default quality the sizes are known when the
// kernels are compiled. The operations and their order are the same for both: so are the bytes. As in
// lanes.hpp, templates only.

namespace skylut::transfer {

/// A number known when the kernels are compiled, and what it and any other number are worth.
template <int kValue>
struct Constant {
  static constexpr int value = kValue;
};
template <class V>
constexpr int value_of(int number) {
  return number;
}
template <class V, int kValue>
constexpr int value_of(Constant<kValue>) {
  return kValue;
}

/// Sizes of any discretisation.
template <class V>
struct AnySizes {
  static constexpr bool kFixed = false;
  int polar_nodes;
  int azimuth_nodes;
  int azimuthal_orders;
  int legendre_terms;

  /// Calls body(m) for every azimuthal order.
  template <class Body>
  void for_orders(const Body& body) const {
    for (int m = 0; m < azimuthal_orders; ++m) body(m);
  }
};

/// Sizes that follow from the highest Legendre degree, with a number of polar nodes of a hemisphere.
template <class V, int kMaxL, int kPolarNodes>
struct FixedSizes {
  static constexpr bool kFixed = true;
  static constexpr int polar_nodes = kPolarNodes;
  static constexpr int azimuthal_orders = azimuthal_order_for(kMaxL) + 1;
  static constexpr int azimuth_nodes = azimuth_nodes_for(azimuthal_order_for(kMaxL));
  static constexpr int legendre_terms = kMaxL + 1;

  template <class Body, int kOrder = 0>
  void for_orders(const Body& body, Constant<kOrder> order = {}) const {
    body(order);
    if constexpr (kOrder + 1 < azimuthal_orders) for_orders(body, Constant<kOrder + 1>{});
  }

  static bool fit(int polar, int azimuths, int orders, int terms) {
    return polar == polar_nodes && azimuths == azimuth_nodes && orders == azimuthal_orders &&
           terms == legendre_terms;
  }
};

/// The entries of a matrix in panels (see apply_matrix) times a vector, with both sizes known: panels two by
/// two, so that ten sums run beside each other while each waits for its last addition.
template <class V, int kRows, int kColumns>
inline void apply_fixed_matrix(const float* panels, const V* in, std::ptrdiff_t in_stride, V* out,
                               std::ptrdiff_t out_stride) {
  constexpr int kTwoPanels = 2 * kPanel;
#pragma GCC unroll 8
  for (int first = 0; first < kRows; first += kTwoPanels) {
    const int rows = kRows - first < kTwoPanels ? kRows - first : kTwoPanels;
    V sum[kTwoPanels] = {};
    const float* entry = panels + static_cast<std::ptrdiff_t>(first) * kColumns;
    const float* next = entry + kPanel * kColumns;
#pragma GCC unroll 4
    for (int column = 0; column < kColumns; ++column) {
      const V value = in[column * in_stride];
#pragma GCC unroll 10
      for (int row = 0; row < rows; ++row)
        sum[row] +=
            value * (row < kPanel ? entry[column * kPanel + row] : next[column * kPanel + row - kPanel]);
    }
#pragma GCC unroll 10
    for (int row = 0; row < rows; ++row) out[(first + row) * out_stride] = sum[row];
  }
}

/// The matrix of an azimuthal order m: from legendre_terms - m degrees to the first `count` polar nodes, or
/// more.
template <class V, class Sizes, class Order>
inline void polar_of_degrees(const Sizes& sizes, Order m, int count, const float* panels, const V* degree,
                             V* polar, std::ptrdiff_t stride) {
  if constexpr (Sizes::kFixed) {
    constexpr int kDegrees = Sizes::legendre_terms - Order::value;
    if (count <= kPanel)
      apply_fixed_matrix<V, kPanel, kDegrees>(panels, degree, 1, polar, stride);
    else
      apply_fixed_matrix<V, Sizes::polar_nodes, kDegrees>(panels, degree, 1, polar, stride);
  } else {
    apply_matrix(panels, count, sizes.legendre_terms - m, degree, 1, polar, stride);
  }
}

/// And from the polar nodes to the degrees.
template <class V, class Sizes, class Order>
inline void degrees_of_polar(const Sizes& sizes, Order m, const float* panels, const V* polar,
                             std::ptrdiff_t stride, V* degree) {
  if constexpr (Sizes::kFixed)
    apply_fixed_matrix<V, Sizes::legendre_terms - Order::value, Sizes::polar_nodes>(panels, polar, stride,
                                                                                    degree, 1);
  else
    apply_matrix(panels, sizes.legendre_terms - m, sizes.polar_nodes, polar, stride, degree, 1);
}

/// Calls solve(sizes) with the fixed sizes that fit, else with any.
template <class V, class Solve>
inline auto with_sizes(int polar, int azimuths, int orders, int terms, const Solve& solve) {
  using Rayleigh = FixedSizes<V, 2, 10>;
  using Haze8 = FixedSizes<V, 8, 10>;
  using Haze10 = FixedSizes<V, 10, 10>;
  using Haze20 = FixedSizes<V, 20, 14>;
  if (Rayleigh::fit(polar, azimuths, orders, terms)) return solve(Rayleigh{});
  if (Haze8::fit(polar, azimuths, orders, terms)) return solve(Haze8{});
  if (Haze10::fit(polar, azimuths, orders, terms)) return solve(Haze10{});
  if (Haze20::fit(polar, azimuths, orders, terms)) return solve(Haze20{});
  return solve(AnySizes<V>{polar, azimuths, orders, terms});
}

}  // namespace skylut::transfer
