#pragma once

#include "angular_grid.hpp"
#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

// What the forward peak that delta-M cuts off scatters into grazing directions, less what it takes from them.
// As in lanes.hpp, templates only. [theory.md §4.6, L6; horizon_peak.hpp]

namespace skylut::transfer {

/// The radiance that the sweep finds near the ground at all its polar nodes, by azimuthal orders.
template <class V>
class HorizonLight {
 public:
  HorizonLight(const SweepView& grid, const OpticsView& optics)
      : grid_(grid),
        wanted_(optics.horizon_peaks > 0),
        radiance_(wanted_ ? index(grid.horizon.levels, 0) : 0) {}

  bool wanted() const { return wanted_; }

  /// Whether the sweep that follows may be the last for a lane; what it finds is kept only then.
  void open(bool may_be_last) { open_ = wanted_ && may_be_last; }

  /// Keeps what the sweep has found at a level, in the lanes that have not converged.
  /// @param order  Σ_k I(φ_k) cos mφ_k, [polar node][m]
  void keep(Hemisphere hemisphere, int level, int node, LaneMask<V> active, const V* order) {
    if (!open_) return;
    const int place = grid_.horizon.place_of_level[level];
    if (place < 0) return;
    const int size = grid_.polar_nodes * grid_.azimuthal_orders;
    V* kept = radiance_.data() + index(place, node) + hemisphere * size;
    if (any_lane<V>(!active))
      for (int i = 0; i < size; ++i) kept[i] = select<V>(active, order[i], kept[i]);
    else
      for (int i = 0; i < size; ++i) kept[i] = order[i];
  }

  /// Of a level that is kept: [hemisphere][polar node][m].
  const V* at(int level, int node) const { return radiance_.data() + index(level, node); }

 private:
  std::size_t index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) *
           static_cast<std::size_t>(2 * grid_.polar_nodes * grid_.azimuthal_orders);
  }

  const SweepView& grid_;
  bool wanted_;
  bool open_ = false;
  LaneArray<V> radiance_;  // [level][sun node][hemisphere][polar node][m]
};

/// C_m = (P_peak * I)_m - I_m at the polar nodes near the horizon.
template <class V>
class HorizonDeficit {
 public:
  HorizonDeficit(const SweepView& grid, const OpticsView& optics, const HorizonLight<V>& light)
      : grid_(grid), wanted_(light.wanted()), deficit_(wanted_ ? index(grid.horizon.levels, 0) : 0) {
    if (wanted_) find(optics, light);
  }

  bool wanted() const { return wanted_; }

  /// Adds `weight` C_m in a grazing direction to every order m.
  void add(const HorizonWeights& direction, int node, V weight, V* order) const {
    add_level(direction, direction.level, node, weight * (1.0f - direction.fraction), order);
    if (direction.fraction > 0.0f)
      add_level(direction, direction.level + 1, node, weight * direction.fraction, order);
  }

 private:
  int row_size() const { return 2 * grid_.polar_nodes * grid_.azimuthal_orders; }
  std::size_t index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) *
           static_cast<std::size_t>(2 * grid_.horizon.nodes * grid_.azimuthal_orders);
  }

  void add_level(const HorizonWeights& direction, int level, int node, V weight, V* order) const {
    const int orders = grid_.azimuthal_orders;
    const V* from = deficit_.data() + index(level, node) +
                    (direction.hemisphere * grid_.horizon.nodes + direction.nodes.first) * orders;
    for (int t = 0; t < 4; ++t) {
      const V scaled = weight * direction.nodes.weight[t];
      for (int m = 0; m < orders; ++m) order[m] += scaled * from[t * orders + m];
    }
  }
  void find(const OpticsView& optics, const HorizonLight<V>& light);
  void find_kernel(const float* moment, V* kernel) const;
  void apply(const V* kernel, V share, const V* light, V* deficit) const;

  const SweepView& grid_;
  bool wanted_;
  LaneArray<V> deficit_;  // [level][sun node][hemisphere][horizon node][m]
};

template <class V>
void HorizonDeficit<V>::find(const OpticsView& optics, const HorizonLight<V>& light) {
  LaneArray<V> kernel(static_cast<std::size_t>(grid_.horizon.nodes * row_size()));
  for (int peak = 0; peak < optics.horizon_peaks; ++peak) {
    find_kernel(optics.horizon_moment + peak * grid_.horizon.degrees * kLaneCount<V>, kernel.data());
    for (int level = 0; level < grid_.horizon.levels; ++level) {
      const int layer = grid_.horizon.layer_of_level[level];
      const V share = load<V>(optics.horizon_share + (layer * optics.horizon_peaks + peak) * kLaneCount<V>);
      for (int node = 0; node < grid_.sun_nodes; ++node)
        apply(kernel.data(), share, light.at(level, node), deficit_.data() + index(level, node));
    }
  }
}

/// P_peak - δ between the nodes near the horizon and the polar nodes, [horizon node][same hemisphere,
/// other][polar node][m]:
///   Σ_l (2l+1) p_l Λ_lm(μ) ½ ∫ Λ_lm(μ') I_m(μ') dμ' - I_m(μ),   Λ_lm(-μ) = (-1)^(l-m) Λ_lm(μ).
template <class V>
void HorizonDeficit<V>::find_kernel(const float* moment, V* kernel) const {
  const HorizonView& view = grid_.horizon;
  const int polar = grid_.polar_nodes;
  const int orders = grid_.azimuthal_orders;
  const float* synthesis = view.synthesis;
  const float* analysis = view.analysis;
  LaneArray<V> sum(static_cast<std::size_t>(2 * view.nodes * polar));  // over even and odd l - m
  for (int m = 0; m < orders; ++m) {
    sum.fill(V{});
    for (int l = m; l < view.degrees; ++l, synthesis += view.nodes, analysis += polar) {
      const V p = load<V>(moment + l * kLaneCount<V>);
      for (int j = 0; j < view.nodes; ++j) {
        V* to = sum.data() + (2 * j + (l - m) % 2) * polar;
        const V scaled = p * synthesis[j];
        for (int k = 0; k < polar; ++k) to[k] += scaled * analysis[k];
      }
    }
    for (int j = 0; j < view.nodes; ++j) {
      const V* even = sum.data() + 2 * j * polar;
      const V* odd = even + polar;
      V* to = kernel + j * row_size();
      for (int k = 0; k < polar; ++k) {
        to[k * orders + m] = even[k] + odd[k];
        to[(polar + k) * orders + m] = even[k] - odd[k];
      }
      to[j * orders + m] -= 1.0f / static_cast<float>(grid_.azimuth_nodes);
    }
  }
}

/// Adds the share of one peak to the C_m of one level and sun node.
template <class V>
void HorizonDeficit<V>::apply(const V* kernel, V share, const V* light, V* deficit) const {
  const int orders = grid_.azimuthal_orders;
  const int half = row_size() / 2;
  const V* falling = light;
  const V* rising = light + half;
  for (int j = 0; j < grid_.horizon.nodes; ++j) {
    const V* same = kernel + j * row_size();
    const V* other = same + half;
    for (int m = 0; m < orders; ++m) {
      V down{};
      V up{};
      V down_from_up{};
      V up_from_down{};
      for (int i = m; i < half; i += orders) {
        down += same[i] * falling[i];
        down_from_up += other[i] * rising[i];
        up += same[i] * rising[i];
        up_from_down += other[i] * falling[i];
      }
      deficit[j * orders + m] += share * (down + down_from_up);
      deficit[(grid_.horizon.nodes + j) * orders + m] += share * (up + up_from_down);
    }
  }
}

}  // namespace skylut::transfer
