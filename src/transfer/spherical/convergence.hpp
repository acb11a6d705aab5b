#pragma once

#include "diffusion_correction.hpp"
#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

namespace skylut::transfer {

/// The changes of successive iterations fall off like λ^n. Per lane and sun node: λ from the last two
/// changes of the moments (l <= 2, m = 0), and the error left as λ/(1-λ) times the last change. Every third
/// iteration all moments of the column are extrapolated by as much as M_00 has still to go (Lyusternik 1947);
/// the iteration after that has no predecessor to compare with and is not judged. [I1-I3]
/// Thick columns are left to DiffusionCorrection instead; what it adds counts as change. [I5]
template <class V>
class Convergence {
 public:
  Convergence(const SweepView& grid, const OpticsView& optics)
      : grid_(grid),
        diffusion_(grid, optics),
        monitored_(count(grid.sublayers + 1) * kMonitored),
        mean_change_(count(grid.sublayers + 1)),
        last_change_(count(1)) {}

  /// Whether lanes may converge in an iteration, counted from 1.
  static bool judges(int iteration) { return iteration > 1 && iteration % kExtrapolateEvery != 1; }

  /// Judges an iteration and, every third time, extrapolates the moments of both hemispheres
  /// [level][node][moment].
  /// @return lanes not yet converged
  LaneMask<V> accelerate_and_test(int iteration, float tolerance, LaneArray<V> (&hemisphere)[2],
                                  LaneMask<V> active);

  /// The largest of all lanes, each when it was last judged.
  float error_left() const {
    float error[kLaneCount<V>];
    store(error_left_, error);
    float largest = 0.0f;
    for (const float lane : error) largest = lane > largest ? lane : largest;
    return largest;
  }

 private:
  static constexpr int kMonitored = 3;
  static constexpr int kExtrapolateEvery = 3;

  std::size_t count(int levels) const {
    return static_cast<std::size_t>(levels) * static_cast<std::size_t>(grid_.sun_nodes);
  }
  std::size_t moment_index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) * static_cast<std::size_t>(grid_.moments);
  }

  const SweepView& grid_;
  DiffusionCorrection<V> diffusion_;
  LaneArray<V> monitored_;    // M_00, M_10, M_20 after the last iteration [level][node][kMonitored]
  LaneArray<V> mean_change_;  // last change of M_00 [level][node]
  LaneArray<V> last_change_;  // summed over the column [node]
  V error_left_{};            // of each lane, when it was last judged
};

template <class V>
LaneMask<V> Convergence<V>::accelerate_and_test(int iteration, float tolerance, LaneArray<V> (&hemisphere)[2],
                                                LaneMask<V> active) {
  const int levels = grid_.sublayers + 1;
  const bool judged = judges(iteration);
  const bool extrapolates = iteration % kExtrapolateEvery == 0;
  LaneMask<V> open = judged ? V{} != V{} : V{} == V{};
  // From one sun node to the next no light falls off by more than a thousand, except where none is left (in
  // the night of a planet without curvature): what is below that need not settle.
  const LaneMask<V> corrected = active & diffusion_.thick();
  const bool corrects = any_lane<V>(corrected);
  V scale{};
  V error{};
  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V change{};
    V size{};
    for (int level = 0; level < levels; ++level) {
      const V* down = hemisphere[kDown].data() + moment_index(level, node);
      const V* up = hemisphere[kUp].data() + moment_index(level, node);
      V* monitored =
          monitored_.data() + static_cast<std::size_t>(level * grid_.sun_nodes + node) * kMonitored;
      size += lane_max(monitored[0], -monitored[0]);
      for (int i = 0; i < kMonitored; ++i) {
        const V value = down[i] + up[i];
        const V step = value - monitored[i];
        change += lane_max(step, -step);
        monitored[i] = value;
        if (i == 0) mean_change_.data()[level * grid_.sun_nodes + node] = step;
      }
    }
    if (corrects) {
      change += diffusion_.correct(node, hemisphere, corrected);
      for (int level = 0; level < levels; ++level)
        for (int i = 0; i < kMonitored; ++i)
          monitored_.data()[static_cast<std::size_t>(level * grid_.sun_nodes + node) * kMonitored +
                            static_cast<std::size_t>(i)] =
              hemisphere[kDown].data()[moment_index(level, node) + static_cast<std::size_t>(i)] +
              hemisphere[kUp].data()[moment_index(level, node) + static_cast<std::size_t>(i)];
    }
    V& before = last_change_.data()[node];
    const V ratio = lane_min(select<V>(before > 0.0f, change / (before + 1e-37f), V{}), broadcast<V>(0.97f));
    const V rest = ratio / (1.0f - ratio);
    before = change;
    if (!judged) continue;
    scale = lane_max(size, scale * 1e-3f);
    open |= (change * rest <= scale * tolerance) == LaneMask<V>{};  // also where it is not a number
    error = lane_max(error, change * rest / (scale + 1e-37f));
    if (!extrapolates) continue;
    const V extrapolation = lane_min(rest, broadcast<V>(6.0f));
    for (int level = 0; level < levels; ++level) {
      V* monitored =
          monitored_.data() + static_cast<std::size_t>(level * grid_.sun_nodes + node) * kMonitored;
      V gain = 1.0f +
               extrapolation * mean_change_.data()[level * grid_.sun_nodes + node] / (monitored[0] + 1e-30f);
      gain = lane_max(lane_min(gain, broadcast<V>(2.0f)), broadcast<V>(0.5f));
      gain = select<V>(diffusion_.thick(), broadcast<V>(1.0f), gain);
      gain = select<V>(active, gain, broadcast<V>(1.0f));
      for (const Hemisphere each : {kDown, kUp}) {
        V* moment = hemisphere[each].data() + moment_index(level, node);
        for (int i = 0; i < grid_.moments; ++i) moment[i] *= gain;
      }
      for (int i = 0; i < kMonitored; ++i) monitored[i] *= gain;
    }
  }
  if (judged) error_left_ = select<V>(active, error, error_left_);
  return active & open;
}

}  // namespace skylut::transfer
