#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

// Optical depth between any point and the sun. As in lanes.hpp, templates only. [theory.md §4.6, B1-B4]

namespace skylut::transfer {

/// The tables of SlantDepthGrid for one block of lanes.
template <class V>
class SlantDepthToSun {
 public:
  /// @param extinction_per_km  [layer][lane] of the medium; must outlive this object
  /// @param spreads            whether the beam's spreading by refraction counts as depth, as it does for its
  ///                           light, not for what it has met
  SlantDepthToSun(const SlantDepthView& grid, const float* extinction_per_km, bool spreads = true)
      : extinction_per_km_(extinction_per_km),
        spread_(spreads ? 1.0f : 0.0f),
        from_level_(static_cast<std::size_t>(grid.level_points)),
        from_perigee_(static_cast<std::size_t>(grid.perigee_points)) {
    fill(from_level_, grid.from_level_path_km, grid.layers);
    fill(from_perigee_, grid.from_perigee_path_km, grid.layers);
  }

  V operator()(const SlantDepthWeights& weights) const {
    const V* from_level = from_level_.data() + weights.from_level;
    V depth = load<V>(extinction_per_km_ + weights.layer * kLaneCount<V>) * weights.to_level_km;
    for (int t = 0; t < 4; ++t) depth += from_level[t] * weights.from_level_weight[t];
    if (weights.from_perigee < 0) return depth + spread_ * weights.spread;
    const V* from_perigee = from_perigee_.data() + weights.from_perigee;
    V whole{};
    for (int t = 0; t < 4; ++t) whole += from_perigee[t] * weights.from_perigee_weight[t];
    return lane_max(whole - depth, V{}) + spread_ * weights.spread;
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
  float spread_;
  LaneArray<V> from_level_;
  LaneArray<V> from_perigee_;
};

}  // namespace skylut::transfer
