#pragma once

#include "angular_grid.hpp"
#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

// What the forward peak that delta-M cuts off scatters into grazing directions less than it takes from them.
// As in lanes.hpp, templates only. [theory.md §4.6, L6; horizon_peak.hpp]

namespace skylut::transfer {

/// The radiance that the sweep last found at its polar nodes, by azimuthal orders.
template <class V>
class HorizonRadiance {
 public:
  HorizonRadiance(const SweepView& grid, const OpticsView& optics)
      : grid_(grid), wanted_(optics.horizon_peaks > 0), order_{LaneArray<V>(size()), LaneArray<V>(size())} {}

  bool wanted() const { return wanted_; }
  /// @param order  Σ_k I(φ_k) cos mφ_k, [polar node][m]
  void keep(Hemisphere hemisphere, int level, int node, LaneMask<V> active, const V* order) {
    if (!wanted_) return;
    V* kept = order_[hemisphere].data() + index(level, node);
    for (int i = 0; i < each(); ++i) kept[i] = select<V>(active, order[i], kept[i]);
  }
  const V* at(int hemisphere, int level, int node) const {
    return order_[hemisphere].data() + index(level, node);
  }

 private:
  int each() const { return grid_.polar_nodes * grid_.azimuthal_orders; }
  std::size_t index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) * static_cast<std::size_t>(each());
  }
  std::size_t size() const { return wanted_ ? index(grid_.sublayers + 1, 0) : 0; }

  const SweepView& grid_;
  bool wanted_;
  LaneArray<V> order_[2];  // [level][sun node][polar node][m]
};

/// C_m = (P_peak * I)_m - I_m at the polar nodes near the horizon.
template <class V>
class HorizonDeficit {
 public:
  HorizonDeficit(const SweepView& grid, const OpticsView& optics, const HorizonRadiance<V>& radiance)
      : grid_(grid), wanted_(radiance.wanted()), deficit_{LaneArray<V>(size()), LaneArray<V>(size())} {
    if (wanted_) find(optics, radiance);
  }

  bool wanted() const { return wanted_; }

  /// Adds `weight` C_m in a grazing direction, at `fraction` of the way between two levels, to every order m.
  void add(const HorizonWeights& direction, int level, float fraction, int node, V weight, V* order) const {
    if (!wanted_ || !direction.near) return;
    add_level(direction, level, node, weight * (1.0f - fraction), order);
    if (fraction > 0.0f) add_level(direction, level + 1, node, weight * fraction, order);
  }

 private:
  std::size_t index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) *
           static_cast<std::size_t>(grid_.horizon.nodes * grid_.azimuthal_orders);
  }
  std::size_t size() const { return wanted_ ? index(grid_.sublayers + 1, 0) : 0; }
  std::size_t kernel_size(int m) const {
    return static_cast<std::size_t>(m * grid_.horizon.nodes * 2 * grid_.polar_nodes);
  }

  void add_level(const HorizonWeights& direction, int level, int node, V weight, V* order) const {
    const int orders = grid_.azimuthal_orders;
    const V* from =
        deficit_[direction.hemisphere].data() + index(level, node) + direction.nodes.first * orders;
    for (int t = 0; t < 4; ++t) {
      const V scaled = weight * direction.nodes.weight[t];
      for (int m = 0; m < orders; ++m) order[m] += scaled * from[t * orders + m];
    }
  }
  void find(const OpticsView& optics, const HorizonRadiance<V>& radiance);
  void kernel_of_peak(const float* moment, V* kernel) const;
  void apply(const V* kernel, const HorizonRadiance<V>& radiance, int level);

  const SweepView& grid_;
  bool wanted_;
  LaneArray<V> deficit_[2];  // [level][sun node][horizon node][m]
};

/// P_peak - δ between the nodes near the horizon and the polar nodes of the same and of the other hemisphere,
/// [m][horizon node][same, other][polar node]: Σ_l (2l+1) p_l Λ_lm(μ) ½ ∫ Λ_lm(μ') I_m(μ') dμ', with Λ_lm(-μ)
/// =
/// (-1)^(l-m) Λ_lm(μ).
template <class V>
void HorizonDeficit<V>::kernel_of_peak(const float* moment, V* kernel) const {
  const HorizonView& view = grid_.horizon;
  const int polar = grid_.polar_nodes;
  const float* synthesis = view.synthesis;
  const float* analysis = view.analysis;
  for (int m = 0; m < grid_.azimuthal_orders; ++m) {
    V* of_order = kernel + kernel_size(m);
    for (int l = m; l < view.degrees; ++l, synthesis += view.nodes, analysis += polar) {
      const V p = load<V>(moment + l * kLaneCount<V>);
      // Sums over even and odd l - m for the time being.
      const int parity = (l - m) % 2;
      for (int j = 0; j < view.nodes; ++j) {
        V* to = of_order + (2 * j + parity) * polar;
        const V scaled = p * synthesis[j];
        for (int k = 0; k < polar; ++k) to[k] += scaled * analysis[k];
      }
    }
    for (int j = 0; j < view.nodes; ++j) {
      V* even = of_order + 2 * j * polar;
      V* odd = even + polar;
      for (int k = 0; k < polar; ++k) {
        const V same = even[k] + odd[k];
        odd[k] = even[k] - odd[k];
        even[k] = same;
      }
      even[j] -= 1.0f / static_cast<float>(grid_.azimuth_nodes);
    }
  }
}

template <class V>
void HorizonDeficit<V>::find(const OpticsView& optics, const HorizonRadiance<V>& radiance) {
  const std::size_t size = kernel_size(grid_.azimuthal_orders);
  LaneArray<V> of_peak(static_cast<std::size_t>(optics.horizon_peaks) * size);
  LaneArray<V> mixed(size);
  for (int peak = 0; peak < optics.horizon_peaks; ++peak)
    kernel_of_peak(optics.horizon_moment + peak * grid_.horizon.degrees * kLaneCount<V>,
                   of_peak.data() + static_cast<std::size_t>(peak) * size);
  for (int level = 0; level <= grid_.sublayers; ++level) {
    // At a boundary between different layers the mean of both.
    const int below = grid_.layer_of_sublayer[level > 0 ? level - 1 : 0];
    const int above = grid_.layer_of_sublayer[level < grid_.sublayers ? level : level - 1];
    mixed.fill(V{});
    for (int peak = 0; peak < optics.horizon_peaks; ++peak) {
      const V share =
          0.5f * (load<V>(optics.horizon_share + (below * optics.horizon_peaks + peak) * kLaneCount<V>) +
                  load<V>(optics.horizon_share + (above * optics.horizon_peaks + peak) * kLaneCount<V>));
      const V* kernel = of_peak.data() + static_cast<std::size_t>(peak) * size;
      for (std::size_t i = 0; i < size; ++i) mixed.data()[i] += share * kernel[i];
    }
    apply(mixed.data(), radiance, level);
  }
}

template <class V>
void HorizonDeficit<V>::apply(const V* kernel, const HorizonRadiance<V>& radiance, int level) {
  const int orders = grid_.azimuthal_orders;
  const int polar = grid_.polar_nodes;
  for (int node = 0; node < grid_.sun_nodes; ++node)
    for (const Hemisphere hemisphere : {kDown, kUp}) {
      const V* same = radiance.at(hemisphere, level, node);
      const V* other = radiance.at(1 - hemisphere, level, node);
      V* deficit = deficit_[hemisphere].data() + index(level, node);
      for (int m = 0; m < orders; ++m) {
        const V* row = kernel + kernel_size(m);
        for (int j = 0; j < grid_.horizon.nodes; ++j, row += 2 * polar) {
          V sum{};
          for (int k = 0; k < polar; ++k)
            sum += row[k] * same[k * orders + m] + row[polar + k] * other[k * orders + m];
          deficit[j * orders + m] = sum;
        }
      }
    }
}

}  // namespace skylut::transfer
