#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

// Q and U between the nodes of the sweep and their moments. As in lanes.hpp, templates only.
// [docs/polarisation.md P5-P7]

namespace skylut::transfer {

/// Scratch space and the transforms of one block.
template <class V>
class PolarisedTransform {
 public:
  explicit PolarisedTransform(const SweepView& grid)
      : grid_(grid),
        view_(grid.polarised),
        plus_(static_cast<std::size_t>(view_.moments)),
        minus_(static_cast<std::size_t>(view_.moments)),
        q_(static_cast<std::size_t>(grid.polar_nodes * view_.orders)),
        u_(static_cast<std::size_t>(grid.polar_nodes * view_.orders)) {}

  /// What scatters into Q and U, and what Q scatters into I: from the light's moments, of I with the beam's
  /// and of Q and U of both hemispheres, by the layer's matrix
  ///   (I, Q, U) → (alpha1 I + beta1 Q, beta1 I + alpha2 Q, alpha3 U) of every degree.
  /// @param intensity  moment of I by its place, a function
  /// @param falling, rising  moments of Q, then of U
  /// @param factor  ω (2l+1) (beta1, alpha2, alpha3) of the layer, [degree][3][lane]
  /// @param scaled  moments of the source of I, to which Q's share is added
  template <class Intensity>
  void scatter(const Intensity& intensity, const V* falling, const V* rising, const float* factor,
               V* scaled) {
    for (int i = 0; i < view_.moments; ++i) {
      const float* matrix = factor + view_.moment_degree[i] * 3 * kLaneCount<V>;
      const V beta1 = load<V>(matrix);
      const int place = view_.moment_of_intensity[i];
      const V q = falling[i] + rising[i];
      const V u = falling[view_.moments + i] + rising[view_.moments + i];
      scaled[place] += beta1 * q;
      const V to_q = beta1 * intensity(place) + load<V>(matrix + kLaneCount<V>) * q;
      const V to_u = load<V>(matrix + 2 * kLaneCount<V>) * u;
      plus_.data()[i] = to_q + to_u;
      minus_.data()[i] = to_q - to_u;
    }
  }

  /// Q and U of what scatter() left, in the first `polar_count` polar nodes. [polar][azimuth]
  void synthesise(Hemisphere hemisphere, int polar_count, V* q, V* u) {
    const int orders = view_.orders;
    for (int m = 0; m < orders; ++m) {
      const int first = view_.moment_offset[m];
      const int terms = view_.moment_offset[m + 1] - first;
      apply_matrix(view_.polar_synthesis[hemisphere][0][m], polar_count, terms, plus_.data() + first, 1,
                   q_.data() + m, orders);
      apply_matrix(view_.polar_synthesis[hemisphere][1][m], polar_count, terms, minus_.data() + first, 1,
                   u_.data() + m, orders);
    }
    for (int i = 0; i < polar_count * orders; ++i) {
      const V half_plus = q_.data()[i];
      const V half_minus = u_.data()[i];
      q_.data()[i] = half_plus + half_minus;
      u_.data()[i] = half_plus - half_minus;
    }
    for (int j = 0; j < polar_count; ++j) {
      spread(view_.cosine_synthesis, 0, q_.data() + j * orders, q + j * grid_.azimuth_nodes);
      spread(view_.sine_synthesis, 1, u_.data() + j * orders, u + j * grid_.azimuth_nodes);
    }
  }

  /// Moments of Q and U, [Q, U][moment], of the radiance of one hemisphere. [polar][azimuth]
  void analyse(Hemisphere hemisphere, const V* q, const V* u, V* found) {
    const int orders = view_.orders;
    for (int j = 0; j < grid_.polar_nodes; ++j) {
      gather(view_.cosine_analysis, 0, q + j * grid_.azimuth_nodes, q_.data() + j * orders);
      gather(view_.sine_analysis, 1, u + j * grid_.azimuth_nodes, u_.data() + j * orders);
    }
    for (int i = 0; i < grid_.polar_nodes * orders; ++i) {
      const V plus = q_.data()[i] + u_.data()[i];
      u_.data()[i] = q_.data()[i] - u_.data()[i];
      q_.data()[i] = plus;
    }
    for (int m = 0; m < orders; ++m) {
      const int first = view_.moment_offset[m];
      const int terms = view_.moment_offset[m + 1] - first;
      apply_matrix(view_.polar_analysis[hemisphere][0][m], terms, grid_.polar_nodes, q_.data() + m, orders,
                   plus_.data() + first, 1);
      apply_matrix(view_.polar_analysis[hemisphere][1][m], terms, grid_.polar_nodes, u_.data() + m, orders,
                   minus_.data() + first, 1);
    }
    for (int i = 0; i < view_.moments; ++i) {
      found[i] = plus_.data()[i] + minus_.data()[i];
      found[view_.moments + i] = plus_.data()[i] - minus_.data()[i];
    }
  }

 private:
  int orders_of(int parity) const { return (view_.orders + 1 - parity) / 2; }

  /// From orders to azimuth nodes, which mirror each other about π/2: cos mφ is even there for even m, sin mφ
  /// for odd. @param even  parity of m whose functions are even
  void spread(const float* const* panels, int even, const V* order, V* azimuth) const {
    const int half = grid_.azimuth_nodes / 2;
    V sum[kMostAzimuths / 2] = {};
    V difference[kMostAzimuths / 2] = {};
    apply_matrix(panels[even], half, orders_of(even), order + even, 2, sum, 1);
    apply_matrix(panels[1 - even], half, orders_of(1 - even), order + 1 - even, 2, difference, 1);
    for (int k = 0; k < half; ++k) {
      azimuth[k] = sum[k] + difference[k];
      azimuth[grid_.azimuth_nodes - 1 - k] = sum[k] - difference[k];
    }
  }

  /// And back.
  void gather(const float* const* panels, int even, const V* azimuth, V* order) const {
    const int half = grid_.azimuth_nodes / 2;
    V sum[kMostAzimuths / 2];
    V difference[kMostAzimuths / 2];
    for (int k = 0; k < half; ++k) {
      sum[k] = azimuth[k] + azimuth[grid_.azimuth_nodes - 1 - k];
      difference[k] = azimuth[k] - azimuth[grid_.azimuth_nodes - 1 - k];
    }
    apply_matrix(panels[even], orders_of(even), half, sum, 1, order + even, 2);
    apply_matrix(panels[1 - even], orders_of(1 - even), half, difference, 1, order + 1 - even, 2);
  }

  const SweepView& grid_;
  const PolarisedView& view_;
  LaneArray<V> plus_;   // of Q + U [moment]
  LaneArray<V> minus_;  // of Q - U
  LaneArray<V> q_;      // [polar][m]
  LaneArray<V> u_;
};

}  // namespace skylut::transfer
