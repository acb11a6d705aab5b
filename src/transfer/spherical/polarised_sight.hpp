#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

// What a line of sight sees of polarised diffuse light. As in lanes.hpp, templates only.
// [docs/polarisation.md P8-P9]

namespace skylut::transfer {

/// What one source point's moments contribute in one direction of light, by azimuthal orders: Q's to I, and
/// those of I, Q and U to Q and U where these are asked for.
template <class V>
class PolarisedSource {
 public:
  explicit PolarisedSource(const SweepView& grid)
      : view_(grid.polarised), weight_(static_cast<std::size_t>(7 * view_.moments)) {}

  bool wanted() const { return view_.moments > 0; }

  /// @param polar         Λ_lm of the direction, by moments of I
  /// @param r, t          R_lm and T_lm; null: only I is asked for
  /// @param degree_weight  [degree][beta1, alpha2, alpha3]: the layers' matrices times their formal solution
  void weigh(const float* polar, const float* r, const float* t, const V* degree_weight) {
    for (int i = 0; i < view_.moments; ++i) {
      const V* matrix = degree_weight + 3 * view_.moment_degree[i];
      at(kIFromQ)[i] = matrix[0] * polar[view_.moment_of_intensity[i]];
      if (r == nullptr) continue;
      at(kQFromI)[i] = matrix[0] * r[i];
      at(kQFromQ)[i] = matrix[1] * r[i];
      at(kQFromU)[i] = matrix[2] * -t[i];
      at(kUFromI)[i] = matrix[0] * -t[i];
      at(kUFromQ)[i] = matrix[1] * -t[i];
      at(kUFromU)[i] = matrix[2] * r[i];
    }
  }

  /// @param polarised  moments of Q, then of U
  /// @param orders     of I, [m]
  void add_to_intensity(const V* polarised, V* orders) const {
    const V* weight = at(kIFromQ);
    for (int m = 0; m < view_.orders; ++m)
      for (int i = view_.moment_offset[m]; i < view_.moment_offset[m + 1]; ++i)
        orders[m] += weight[i] * polarised[i];
  }

  /// @param q, u  [m]: of the cosines and of the sines
  void find(const V* intensity, const V* polarised, V* q, V* u) const {
    for (int m = 0; m < view_.orders; ++m) {
      V sum_q{};
      V sum_u{};
      for (int i = view_.moment_offset[m]; i < view_.moment_offset[m + 1]; ++i) {
        const V of_i = intensity[view_.moment_of_intensity[i]];
        const V of_q = polarised[i];
        const V of_u = polarised[view_.moments + i];
        sum_q += at(kQFromI)[i] * of_i + at(kQFromQ)[i] * of_q + at(kQFromU)[i] * of_u;
        sum_u += at(kUFromI)[i] * of_i + at(kUFromQ)[i] * of_q + at(kUFromU)[i] * of_u;
      }
      q[m] = sum_q;
      u[m] = sum_u;
    }
  }

 private:
  enum Share { kIFromQ, kQFromI, kQFromQ, kQFromU, kUFromI, kUFromQ, kUFromU };
  V* at(Share share) { return weight_.data() + static_cast<int>(share) * view_.moments; }
  const V* at(Share share) const { return weight_.data() + static_cast<int>(share) * view_.moments; }

  const PolarisedView& view_;
  LaneArray<V> weight_;
};

/// Adds one source point's Q and U to those of every pair.
/// @param orders   [Q, U][sun node][m]
/// @param cosines, sines  [pair][m], `stride` apart: (2-δ_m0) cos mφ, sin mφ
/// @param out      [Q, U][pair]
template <class V>
inline void add_polarised_light(const SweepView& grid, int pairs, const InterpolationWeights* suns,
                                const float* cosines, const float* sines, int stride, const V* orders,
                                V* out) {
  const int count = grid.polarised.orders;
  const V* of_u = orders + static_cast<std::ptrdiff_t>(grid.sun_nodes) * count;
  for (int pair = 0; pair < pairs; ++pair, cosines += stride, sines += stride)
    for (int t = 0; t < 4; ++t) {
      const int node = (suns[pair].first + t) * count;
      V q{};
      V u{};
      for (int m = 0; m < count; ++m) {
        q += orders[node + m] * cosines[m];
        u += of_u[node + m] * sines[m];
      }
      out[pair] += q * suns[pair].weight[t];
      out[pairs + pair] += u * suns[pair].weight[t];
    }
}

}  // namespace skylut::transfer
