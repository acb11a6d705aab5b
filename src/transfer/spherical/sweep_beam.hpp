#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"
#include "slant_depth.hpp"

// The sunbeam where the sweep needs it. As in lanes.hpp, templates only. [theory.md §4.4, M4]

namespace skylut::transfer {

/// Transmission of the sunbeam at every level, and what makes the mean of its two ends the mean over a
/// sublayer. The source that a ray collects in the sublayer needs the mean of T over the optical depth,
///   T̄ = Σ Δτ T / Σ Δτ, T in the middle of every piece of one layer; for one piece Simpson's (T₀ + 4T_½ +
///   T₁)/6,
/// while transport takes T as linear between the ends, of mean (T₀ + T₁)/2. Both are therefore multiplied by
///   c = 2T̄/(T₀ + T₁). Without it a low sun is 1 % off. [M4]
template <class V>
class SweepBeam {
 public:
  SweepBeam(const SweepView& grid, const OpticsView& optics, const SlantDepthToSun<V>& slant_depth)
      : grid_(grid),
        transmission_(static_cast<std::size_t>((grid.sublayers + 1) * grid.sun_nodes)),
        mean_factor_(static_cast<std::size_t>(grid.sublayers * grid.sun_nodes)) {
    for (int node = 0; node < grid.sun_nodes; ++node) attenuate(optics, slant_depth, node);
  }

  V at(int level, int node) const { return transmission_.data()[level * grid_.sun_nodes + node]; }
  V mean_factor(int sublayer, int node) const {
    return mean_factor_.data()[sublayer * grid_.sun_nodes + node];
  }

 private:
  void attenuate(const OpticsView& optics, const SlantDepthToSun<V>& slant_depth, int node) {
    const int levels = grid_.sublayers + 1;
    const auto transmission = [&](int point) {
      const SlantDepthWeights& weights = grid_.beam_weights[point * grid_.sun_nodes + node];
      return weights.from_level == kShadow ? V{} : exp_minus(slant_depth(weights));
    };
    V* level = transmission_.data() + node;
    for (int k = 0; k < levels; ++k) level[k * grid_.sun_nodes] = transmission(k);
    for (int k = 0; k < grid_.sublayers; ++k) {
      V sum{};
      V weights{};
      for (int piece = grid_.first_piece[k]; piece < grid_.first_piece[k + 1]; ++piece) {
        const V weight = load<V>(optics.layers.extinction_per_km + grid_.piece_layer[piece] * kLaneCount<V>) *
                             grid_.piece_thickness_km[piece] +
                         1e-30f;
        sum += weight * transmission(levels + piece);
        weights += weight;
      }
      const V ends = level[k * grid_.sun_nodes] + level[(k + 1) * grid_.sun_nodes];
      V mean = sum / weights;
      if (grid_.first_piece[k + 1] - grid_.first_piece[k] == 1) mean = (4.0f * mean + ends) * (1.0f / 6.0f);
      mean_factor_.data()[k * grid_.sun_nodes + node] =
          select<V>(ends > 1e-30f, 2.0f * mean / (ends + 1e-30f), V{});
    }
  }

  const SweepView& grid_;
  LaneArray<V> transmission_;  // [level][node]
  LaneArray<V> mean_factor_;   // [sublayer][node]
};

}  // namespace skylut::transfer
