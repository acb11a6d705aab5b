#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"

// Optical depth between any point and the sun. As in lanes.hpp, templates only. [theory.md §4.6, B1-B4]

namespace skylut::transfer {

/// The tables of SunDepthGrid for one block of lanes.
template <class V>
class SunDepth {
 public:
  /// @param extinction_per_km  [layer][lane] of the medium; must outlive this object
  SunDepth(const SunDepthView& grid, const float* extinction_per_km)
      : extinction_per_km_(extinction_per_km),
        rising_(static_cast<std::size_t>(grid.rising_points)),
        half_(static_cast<std::size_t>(grid.half_points)) {
    fill(rising_, grid.rising_path_km, grid.layers);
    fill(half_, grid.half_path_km, grid.layers);
  }

  V operator()(const SunDepthTaps& taps) const {
    const V* rising = rising_.data() + taps.rising;
    V depth = load<V>(extinction_per_km_ + taps.layer * kLaneCount<V>) * taps.to_level_km;
    for (int t = 0; t < 4; ++t) depth += rising[t] * taps.rising_weight[t];
    if (taps.half < 0) return depth;
    const V* half = half_.data() + taps.half;
    V whole{};
    for (int t = 0; t < 4; ++t) whole += half[t] * taps.half_weight[t];
    return lane_max(whole - depth, V{});
  }

 private:
  void fill(LaneArray<V>& table, const float* path_km, int layers) const {
    for (std::size_t point = 0; point < table.size(); ++point, path_km += layers) {
      V sum[4] = {};  // because each addition waits for the one before it
      for (int layer = 0; layer < layers; ++layer)
        sum[layer % 4] += load<V>(extinction_per_km_ + layer * kLaneCount<V>) * path_km[layer];
      table.data()[point] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    }
  }

  const float* extinction_per_km_;
  LaneArray<V> rising_;
  LaneArray<V> half_;
};

}  // namespace skylut::transfer
