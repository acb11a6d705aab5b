#pragma once

// Lanes: one SIMD register holds the same quantity of W columns (wavelengths and aerosol loads) of the
// atmosphere. Geometry is common to all lanes and enters as plain numbers; nothing ever crosses lanes,
// which is why a column's result does not depend on its neighbours.
//
// The code of this header and of the kernels that use it is compiled once per instruction set
// (kernel_*.cpp). Everything here is therefore a template on the register type V, so that every build
// has its own symbols; nothing inline is shared with the rest of the program.

#include <cstddef>
#include <cstdint>

namespace skylut::transfer {

/// A register of W floats (GCC vector extension: +, -, *, / and comparisons work lane by lane).
template <int W>
struct LaneRegister {
  typedef float type __attribute__((vector_size(4 * W)));
};

template <class V>
constexpr int kLaneCount = static_cast<int>(sizeof(V) / sizeof(float));

/// Integer register with as many lanes as V: the result of a comparison (all bits set where true).
template <class V>
using LaneMask = decltype(V{} < V{});

template <class V>
inline V broadcast(float value) {
  return V{} + value;
}

template <class V>
inline V select(LaneMask<V> where, V yes, V no) {
  return where ? yes : no;
}

/// Whether any bit of the first W floats of a register V is set, by folding in halves.
template <class V, int W>
inline bool any_bit(typename LaneRegister<W>::type bits) {
  if constexpr (W == 4) {
    std::int64_t word[2];
    __builtin_memcpy(word, &bits, sizeof(word));
    return (word[0] | word[1]) != 0;
  } else {
    using Half = typename LaneRegister<W / 2>::type;
    LaneMask<Half> half[2];
    __builtin_memcpy(half, &bits, sizeof(bits));
    half[0] |= half[1];
    Half folded;
    __builtin_memcpy(&folded, half, sizeof(folded));
    return any_bit<V, W / 2>(folded);
  }
}

template <class V>
inline bool any_lane(LaneMask<V> where) {
  V bits;
  __builtin_memcpy(&bits, &where, sizeof(V));
  return any_bit<V, kLaneCount<V>>(bits);
}

template <class V>
inline V lane_max(V a, V b) {
  return a > b ? a : b;
}

template <class V>
inline V lane_min(V a, V b) {
  return a < b ? a : b;
}

/// e^-x for x >= 0, relative error below 2e-7; 0 beyond x = 87. Cody-Waite reduction to |r| <= ln2/2
/// and the Taylor polynomial of degree 7 there (remainder (ln2/2)^8/8! = 5e-9).
template <class V>
inline V exp_minus(V x) {
  using Integers = LaneMask<V>;
  constexpr float kLog2e = 1.44269504088896341f;
  constexpr float kLn2High = 0.693359375f;  // exact in 9 bits, so n * kLn2High is exact
  constexpr float kLn2Low = -2.12194440e-4f;
  const V limited = lane_min(x, broadcast<V>(87.0f));
  const Integers n = __builtin_convertvector(limited * kLog2e + 0.5f, Integers);
  const V whole = __builtin_convertvector(n, V);
  const V r = (whole * kLn2High - limited) + whole * kLn2Low;
  V p = broadcast<V>(1.0f / 5040.0f);
  p = p * r + 1.0f / 720.0f;
  p = p * r + 1.0f / 120.0f;
  p = p * r + 1.0f / 24.0f;
  p = p * r + 1.0f / 6.0f;
  p = p * r + 0.5f;
  p = p * r + 1.0f;
  p = p * r + 1.0f;
  const Integers power_bits = (127 - n) << 23;
  V power;
  __builtin_memcpy(&power, &power_bits, sizeof(V));
  return select<V>(x > 87.0f, V{}, p * power);
}

/// Weights of the formal solution over a step of optical depth t with a source linear in optical depth:
///   I = transmission I_upwind + upwind J_upwind + local J_local.
/// upwind = (1-e^-t)/t - e^-t, local = 1 - (1-e^-t)/t (e.g. Olson & Kunasz 1987).
/// [theory.md §4.4, T1]
template <class V>
struct StepWeights {
  V transmission;
  V upwind;
  V local;
};

/// The closed forms lose digits for small t; below 0.5 their series (remainder 0.5^9/10! < 1e-9) are used.
template <class V>
inline StepWeights<V> step_weights(V t) {
  const V transmission = exp_minus(t);
  const V safe = lane_max(t, broadcast<V>(0.25f));
  const V mean = (1.0f - transmission) / safe;
  V series_local = broadcast<V>(-1.0f / 362880.0f);
  V series_upwind = broadcast<V>(-8.0f / 362880.0f);
  constexpr float kFactorial[] = {0, 2, 6, 24, 120, 720, 5040, 40320};  // (n+1)! for n = 1 … 7
  for (int n = 7; n >= 1; --n) {
    const float sign = n % 2 == 1 ? 1.0f : -1.0f;
    series_local = series_local * t + sign / kFactorial[n];
    series_upwind = series_upwind * t + sign * static_cast<float>(n) / kFactorial[n];
  }
  const LaneMask<V> thin = t < 0.5f;
  return {transmission, select<V>(thin, series_upwind * t, mean - transmission),
          select<V>(thin, series_local * t, 1.0f - mean)};
}

/// out[row] = Σ_column matrix[row, column] in[column]: a small dense matrix of plain numbers times a
/// vector of lanes, the one operation behind the angular transforms. Matrices are stored in panels of
/// kPanel rows (panel, column, row in the panel) so that a panel's sums stay in registers.
inline constexpr int kPanel = 5;

template <class V, bool kAccumulate = false>
inline void apply_matrix(const float* panels, int rows, int columns, const V* in, std::ptrdiff_t in_stride,
                         V* out, std::ptrdiff_t out_stride) {
  for (int first = 0; first < rows; first += kPanel) {
    V sum[kPanel] = {};
    const float* entry = panels + static_cast<std::ptrdiff_t>(first) * columns;
    for (int column = 0; column < columns; ++column, entry += kPanel) {
      const V value = in[column * in_stride];
      for (int row = 0; row < kPanel; ++row) sum[row] += value * entry[row];
    }
    const int last = rows - first < kPanel ? rows - first : kPanel;
    for (int row = 0; row < last; ++row) {
      V* to = out + (first + row) * out_stride;
      *to = kAccumulate ? *to + sum[row] : sum[row];
    }
  }
}

}  // namespace skylut::transfer
