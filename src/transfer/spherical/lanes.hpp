#pragma once

// Lanes: one SIMD register holds the same quantity of W columns (wavelengths and aerosol loads) of the
// atmosphere. Geometry is common to all lanes and enters as plain numbers; nothing ever crosses lanes,
// which is why a column's result does not depend on its neighbours. Read V as "a number".
//
// The code of this header and of the kernels that use it is compiled once per instruction set
// (kernel_*.cpp). Everything here is therefore a template on the register type V, so that every build
// has its own symbols; nothing inline is shared with the rest of the program.

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace skylut::transfer {

/// A register of W floats (GCC vector extension: +, -, *, / and comparisons work lane by lane).
template <int W>
struct LaneRegister {
  typedef float type __attribute__((vector_size(4 * W)));
};

/// What V is made of. A plain float or double is a register of one lane: the kernels compile for it without
/// any vector, as a reference that reads like a textbook and for machines that no build was made for.
template <class V, bool kPlain = std::is_floating_point_v<V>>
struct LaneTraits {
  using Scalar = V;
  using Integers = std::conditional_t<sizeof(V) == 4, std::int32_t, std::int64_t>;
  static constexpr int kCount = 1;
};
template <class V>
struct LaneTraits<V, false> {
  using Scalar = std::remove_cvref_t<decltype(V{}[0])>;
  using Integers = decltype(V{} < V{});
  static constexpr int kCount = static_cast<int>(sizeof(V) / sizeof(Scalar));
};

template <class V>
constexpr int kLaneCount = LaneTraits<V>::kCount;

template <class V>
constexpr bool kIsPlain = std::is_floating_point_v<V>;

/// Result of a comparison: an integer register with as many lanes as V (all bits set where true), or a bool.
template <class V>
using LaneMask = decltype(V{} < V{});

inline constexpr float kInversePi = 0.318309886f;       // 1/π
inline constexpr float kInverseFourPi = 0.0795774715f;  // 1/4π

template <class V>
inline V broadcast(float value) {
  return V{} + value;
}

/// The tables and views of the kernels hold floats, whatever V is.
template <class V>
inline V load(const float* from) {
  V value{};
  if constexpr (std::is_same_v<typename LaneTraits<V>::Scalar, float>) {
    __builtin_memcpy(&value, from, sizeof(V));
  } else if constexpr (kIsPlain<V>) {
    value = static_cast<V>(*from);
  } else {
    for (int lane = 0; lane < kLaneCount<V>; ++lane) value[lane] = from[lane];
  }
  return value;
}

template <class V>
inline void store(V value, float* to) {
  if constexpr (std::is_same_v<typename LaneTraits<V>::Scalar, float>) {
    __builtin_memcpy(to, &value, sizeof(V));
  } else if constexpr (kIsPlain<V>) {
    *to = static_cast<float>(value);
  } else {
    for (int lane = 0; lane < kLaneCount<V>; ++lane) to[lane] = static_cast<float>(value[lane]);
  }
}

template <class V>
inline V select(LaneMask<V> where, V yes, V no) {
  return where ? yes : no;
}

template <int kBytes>
struct BitRegister {
  typedef long long type __attribute__((vector_size(kBytes)));
};

/// Whether any bit of a register of that many bytes is set, by folding in halves. (V makes it a build's own.)
template <class V, int kBytes>
inline bool any_bit(const void* bits) {
  typename BitRegister<kBytes>::type word;
  __builtin_memcpy(&word, bits, sizeof(word));
  if constexpr (kBytes == 16) {
    return (word[0] | word[1]) != 0;
  } else {
    typename BitRegister<kBytes / 2>::type half[2];
    __builtin_memcpy(half, &word, sizeof(word));
    half[0] |= half[1];
    return any_bit<V, kBytes / 2>(&half[0]);
  }
}

template <class V>
inline bool any_lane(LaneMask<V> where) {
  if constexpr (kIsPlain<V>)
    return where;
  else
    return any_bit<V, static_cast<int>(sizeof(V))>(&where);
}

/// x >= 0 without its fraction.
template <class V>
inline typename LaneTraits<V>::Integers whole_part(V x) {
  if constexpr (kIsPlain<V>)
    return static_cast<typename LaneTraits<V>::Integers>(x);
  else
    return __builtin_convertvector(x, typename LaneTraits<V>::Integers);
}

template <class V>
inline V from_integers(typename LaneTraits<V>::Integers n) {
  if constexpr (kIsPlain<V>)
    return static_cast<V>(n);
  else
    return __builtin_convertvector(n, V);
}

/// 2^-n by its bits; n within the exponents of V.
template <class V>
inline V inverse_power_of_two(typename LaneTraits<V>::Integers n) {
  using Integers = typename LaneTraits<V>::Integers;
  constexpr bool kSingle = std::is_same_v<typename LaneTraits<V>::Scalar, float>;
  const Integers bits = ((kSingle ? 127 : 1023) - n) << (kSingle ? 23 : 52);
  V power;
  __builtin_memcpy(&power, &bits, sizeof(V));
  return power;
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
  constexpr float kLog2e = 1.44269504088896341f;
  constexpr float kLn2High = 0.693359375f;  // exact in 9 bits, so n * kLn2High is exact
  constexpr float kLn2Low = -2.12194440e-4f;
  const V limited = lane_min(x, broadcast<V>(87.0f));
  const typename LaneTraits<V>::Integers n = whole_part<V>(limited * kLog2e + 0.5f);
  const V whole = from_integers<V>(n);
  const V r = (whole * kLn2High - limited) + whole * kLn2Low;
  V p = broadcast<V>(1.0f / 5040.0f);
  p = p * r + 1.0f / 720.0f;
  p = p * r + 1.0f / 120.0f;
  p = p * r + 1.0f / 24.0f;
  p = p * r + 1.0f / 6.0f;
  p = p * r + 0.5f;
  p = p * r + 1.0f;
  p = p * r + 1.0f;
  return select<V>(x > 87.0f, V{}, p * inverse_power_of_two<V>(n));
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
