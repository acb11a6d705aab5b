#pragma once

#include "azimuth_transform.hpp"
#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"
#include "sun_depth.hpp"

// Multiple scattering of one block of lanes: successive orders on short characteristics, with the moments
// of the diffuse radiance as the only unknowns. Reading order: solve, sweep_down, sweep_up, then what
// they call. [theory.md §4.3-4.5]

namespace skylut::transfer {

template <class V>
class DiffuseField {
 public:
  DiffuseField(const SweepView& grid, const OpticsView& optics, const SunDepth<V>& sun_depth)
      : grid_(grid),
        optics_(optics),
        sun_depth_(sun_depth),
        half_{LaneArray<V>(count(grid.sublayers + 1, grid.moments)),
              LaneArray<V>(count(grid.sublayers + 1, grid.moments))},
        beam_gain_(count(grid.sublayers, 1)),
        beam_(count(grid.sublayers + 1, 1)),
        radiance_(count(1, directions())),
        upwind_(count(1, directions())),
        local_source_(count(1, directions())),
        chords_(count(grid.sublayers + 1, grid.chord_nodes * grid.azimuth_nodes)),
        ground_irradiance_(count(1, 1)),
        watched_(count(grid.sublayers + 1, kWatched)),
        mean_change_(count(grid.sublayers + 1, 1)),
        last_change_(count(1, 1)),
        step_weights_(static_cast<std::size_t>(grid.polar_nodes)),
        scaled_moments_(static_cast<std::size_t>(grid.moments)),
        orders_(static_cast<std::size_t>(grid.polar_nodes * grid.azimuthal_orders)) {
    source_half_[kDown] = half_[kDown].data();
    source_half_[kUp] = half_[kUp].data();
  }

  /// Iterates until every lane and sun node has converged (Gauss-Seidel: every step uses the newest field),
  /// or sums the orders asked for one by one (every step uses the field of one order less). [T3, I4]
  /// @return false if a lane has not converged within the limit
  bool solve(const IterationLimits& limits);

  /// Moments of the whole diffuse radiance [level][node][moment] and diffuse irradiance of the ground
  /// [node], after solve.
  LaneArray<V> take_moments() { return static_cast<LaneArray<V>&&>(half_[kDown]); }
  LaneArray<V> take_ground_irradiance() { return static_cast<LaneArray<V>&&>(ground_irradiance_); }

 private:
  static constexpr int kWatched = 3;
  static constexpr int kPushEvery = 3;

  std::size_t count(int levels, int each) const {
    return static_cast<std::size_t>(levels * grid_.sun_nodes * each);
  }
  int directions() const { return grid_.polar_nodes * grid_.azimuth_nodes; }
  std::size_t moment_index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) * static_cast<std::size_t>(grid_.moments);
  }
  V extinction(int layer) const {
    return load<V>(optics_.sweep_layers.extinction_per_km + layer * kLaneCount<V>);
  }

  V beam_transmission(int point, int node) const;
  void attenuate_beam();
  void sweep_down(LaneMask<V> active);
  void reflect_at_ground(LaneMask<V> active, bool by_order);
  void sweep_up(LaneMask<V> active);
  void source(Hemisphere half, int sublayer, int level, int node, int polar_count, V* to);
  void analyse(Hemisphere half, int level, int node, LaneMask<V> active);
  void transport(Hemisphere half, int sublayer, int start_level, int end_level);
  LaneMask<V> accelerate_and_test(int iteration, const IterationLimits& limits, LaneMask<V> active);
  void merge_halves();

  const SweepView& grid_;
  const OpticsView& optics_;
  const SunDepth<V>& sun_depth_;
  const V* source_half_[2];    // the moments that make the source: half_, or those of one order less
  LaneArray<V> half_[2];       // moments of each hemisphere [level][node][moment]
  LaneArray<V> beam_gain_;     // see attenuate_beam [sublayer][node]
  LaneArray<V> beam_;          // transmission of the sunbeam [level][node]
  LaneArray<V> radiance_;      // at the level the sweep has reached [node][direction]
  LaneArray<V> upwind_;        // interpolated in polar angle, at the start of the step
  LaneArray<V> local_source_;  // source at the end of the step, then at its start
  LaneArray<V> chords_;        // downward radiance of grazing directions [level][node][polar][azimuth]
  LaneArray<V> ground_irradiance_;
  LaneArray<V> watched_;      // M_00, M_10, M_20 after the last iteration [level][node][kWatched]
  LaneArray<V> mean_change_;  // last change of M_00 [level][node]
  LaneArray<V> last_change_;  // summed over the column [node]
  LaneArray<StepWeights<V>> step_weights_;  // of the sublayer being crossed [polar]
  LaneArray<V> scaled_moments_;
  LaneArray<V> orders_;
};

template <class V>
bool DiffuseField<V>::solve(const IterationLimits& limits) {
  attenuate_beam();
  LaneMask<V> active = V{} == V{};
  if (limits.orders > 0) {
    LaneArray<V> previous[2] = {LaneArray<V>(half_[kDown].size()), LaneArray<V>(half_[kUp].size())};
    // The last order is added by the line of sight.
    for (int order = 1; order < limits.orders; ++order) {
      for (const Hemisphere half : {kDown, kUp}) {
        previous[half].copy(half_[half]);
        source_half_[half] = previous[half].data();
      }
      sweep_down(active);
      reflect_at_ground(active, true);
      sweep_up(active);
    }
    merge_halves();
    return true;
  }
  for (int iteration = 1; iteration <= limits.max_iterations; ++iteration) {
    sweep_down(active);
    reflect_at_ground(active, false);
    sweep_up(active);
    active = accelerate_and_test(iteration, limits, active);
    bool any = false;
    for (int lane = 0; lane < kLaneCount<V>; ++lane) any = any || active[lane] != 0;
    if (!any) {
      merge_halves();
      return true;
    }
  }
  merge_halves();
  return false;
}

template <class V>
V DiffuseField<V>::beam_transmission(int point, int node) const {
  const SunDepthTaps& taps = grid_.beam_taps[point * grid_.sun_nodes + node];
  return taps.rising == kShadow ? V{} : exp_minus(sun_depth_(taps));
}

/// Transmission of the sunbeam at every level, and the factor that makes the mean of its two ends the mean
/// over a sublayer, weighted by extinction: by Simpson's rule within one layer, else by the middles of the
/// pieces. Without it a low sun is 1 % off. [M4]
template <class V>
void DiffuseField<V>::attenuate_beam() {
  const int levels = grid_.sublayers + 1;
  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V* level = beam_.data() + node;
    for (int k = 0; k < levels; ++k) level[k * grid_.sun_nodes] = beam_transmission(k, node);
    for (int k = 0; k < grid_.sublayers; ++k) {
      V sum{};
      V weights{};
      for (int piece = grid_.first_piece[k]; piece < grid_.first_piece[k + 1]; ++piece) {
        const V weight =
            load<V>(optics_.layers.extinction_per_km + grid_.piece_layer[piece] * kLaneCount<V>) *
                grid_.piece_thickness_km[piece] +
            1e-30f;
        sum += weight * beam_transmission(levels + piece, node);
        weights += weight;
      }
      const V ends = level[k * grid_.sun_nodes] + level[(k + 1) * grid_.sun_nodes];
      V mean = sum / weights;
      if (grid_.first_piece[k + 1] - grid_.first_piece[k] == 1) mean = (4.0f * mean + ends) * (1.0f / 6.0f);
      beam_gain_.data()[k * grid_.sun_nodes + node] =
          select<V>(ends > 1e-30f, 2.0f * mean / (ends + 1e-30f), V{});
    }
  }
}

/// Source J(μ,φ) of a sublayer's medium at one of its levels, in the first `polar_count` polar nodes:
/// J = ω Σ (2l+1) χ_l (2-δ_m0) Λ_lm cos(mφ) [M_lm + T c Λ_lm(-μs)/4π]. [M3, M4]
template <class V>
void DiffuseField<V>::source(Hemisphere half, int sublayer, int level, int node, int polar_count, V* to) {
  const int layer = grid_.layer_of_sublayer[sublayer];
  const V transmission =
      beam_.data()[level * grid_.sun_nodes + node] * beam_gain_.data()[sublayer * grid_.sun_nodes + node];
  const V* down = source_half_[kDown] + moment_index(level, node);
  const V* up = source_half_[kUp] + moment_index(level, node);
  const float* beam_moment = grid_.beam_moment + node * grid_.moments;
  const float* factor = optics_.sweep_layers.source_factor + layer * grid_.degrees * kLaneCount<V>;
  V* scaled = scaled_moments_.data();
  for (int i = 0; i < grid_.moments; ++i)
    scaled[i] = (down[i] + up[i] + transmission * beam_moment[i]) *
                load<V>(factor + grid_.moment_degree[i] * kLaneCount<V>);

  const int orders = grid_.azimuthal_orders;
  V* by_order = orders_.data();
  for (int m = 0; m < orders; ++m)
    apply_matrix(grid_.polar_synthesis[half][m], polar_count, grid_.degrees - m,
                 scaled + grid_.moment_offset[m], 1, by_order + m, orders);
  for (int j = 0; j < polar_count; ++j)
    azimuths_of_orders(grid_, by_order + j * orders, to + j * grid_.azimuth_nodes);
}

/// Moments of one hemisphere's radiance at the level that the sweep has reached. Lanes that have
/// converged keep theirs. [M1, T3]
template <class V>
void DiffuseField<V>::analyse(Hemisphere half, int level, int node, LaneMask<V> active) {
  const int orders = grid_.azimuthal_orders;
  const V* radiance = radiance_.data() + node * directions();
  V* by_order = orders_.data();
  for (int j = 0; j < grid_.polar_nodes; ++j)
    orders_of_azimuths(grid_, radiance + j * grid_.azimuth_nodes, by_order + j * orders);
  V* found = scaled_moments_.data();
  for (int m = 0; m < orders; ++m)
    apply_matrix(grid_.polar_analysis[half][m], grid_.degrees - m, grid_.polar_nodes, by_order + m, orders,
                 found + grid_.moment_offset[m], 1);
  V* kept = half_[half].data() + moment_index(level, node);
  for (int i = 0; i < grid_.moments; ++i) kept[i] = select<V>(active, found[i], kept[i]);
}

/// Carries radiance_ across a sublayer: attenuation and source at the start of every ray, interpolated in
/// polar angle, then in solar zenith angle, plus the source at its end. The azimuth is kept: over one step
/// it turns by less than what the nodes resolve. [T1, T2]
template <class V>
void DiffuseField<V>::transport(Hemisphere half, int sublayer, int start_level, int end_level) {
  const int azimuths = grid_.azimuth_nodes;
  const V beta = extinction(grid_.layer_of_sublayer[sublayer]);
  const PolarStep* steps = grid_.polar_step[half] + sublayer * grid_.polar_nodes;
  int chord_count = 0;
  for (int j = 0; j < grid_.polar_nodes; ++j) {
    step_weights_.data()[j] = step_weights(beta * steps[j].length_km);
    if (steps[j].chord) chord_count = j + 1;
  }

  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V* start_source = local_source_.data() + node * directions();
    source(half, sublayer, start_level, node, grid_.polar_nodes, start_source);
    const V* radiance = radiance_.data() + node * directions();
    V* upwind = upwind_.data() + node * directions();
    for (int j = chord_count; j < grid_.polar_nodes; ++j) {
      const StepWeights<V>& weights = step_weights_.data()[j];
      const Taps& taps = steps[j].upwind;
      V transmitted[4];
      V emitted[4];
      for (int t = 0; t < 4; ++t) {
        transmitted[t] = weights.transmission * taps.weight[t];
        emitted[t] = weights.upwind * taps.weight[t];
      }
      const V* from = radiance + taps.first * azimuths;
      const V* made = start_source + taps.first * azimuths;
      for (int k = 0; k < azimuths; ++k) {
        V sum{};
        for (int t = 0; t < 4; ++t)
          sum += transmitted[t] * from[t * azimuths + k] + emitted[t] * made[t * azimuths + k];
        upwind[j * azimuths + k] = sum;
      }
    }
    if (chord_count == 0) continue;
    // A chord entered downwards through the level where it leaves.
    source(kDown, sublayer, end_level, node, chord_count, start_source);
    const V* entered = chords_.data() + static_cast<std::size_t>(end_level * grid_.sun_nodes + node) *
                                            static_cast<std::size_t>(grid_.chord_nodes * azimuths);
    for (int j = 0; j < chord_count; ++j)
      for (int d = j * azimuths; d < (j + 1) * azimuths; ++d)
        upwind[d] = step_weights_.data()[j].transmission * entered[d] +
                    step_weights_.data()[j].upwind * start_source[d];
  }

  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V* end_source = local_source_.data() + node * directions();
    source(half, sublayer, end_level, node, grid_.polar_nodes, end_source);
    V* radiance = radiance_.data() + node * directions();
    const Taps* taps = grid_.sun_taps[half] + static_cast<std::size_t>(sublayer * grid_.sun_nodes + node) *
                                                  static_cast<std::size_t>(directions());
    for (int j = 0; j < grid_.polar_nodes; ++j) {
      const V local = step_weights_.data()[j].local;
      for (int d = j * azimuths; d < (j + 1) * azimuths; ++d) {
        const V* from = upwind_.data() + taps[d].first * directions() + d;
        V sum = local * end_source[d];
        for (int t = 0; t < 4; ++t) sum += from[t * directions()] * taps[d].weight[t];
        radiance[d] = sum;
      }
    }
  }
}

template <class V>
void DiffuseField<V>::sweep_down(LaneMask<V> active) {
  radiance_.fill(V{});  // nothing but the beam enters at the top
  const int chord_directions = grid_.chord_nodes * grid_.azimuth_nodes;
  for (int level = grid_.sublayers - 1; level >= -1; --level) {
    for (int node = 0; node < grid_.sun_nodes; ++node) {
      V* kept = chords_.data() + static_cast<std::size_t>((level + 1) * grid_.sun_nodes + node) *
                                     static_cast<std::size_t>(chord_directions);
      for (int d = 0; d < chord_directions; ++d) kept[d] = radiance_.data()[node * directions() + d];
    }
    if (level < 0) break;
    transport(kDown, level, level + 1, level);
    for (int node = 0; node < grid_.sun_nodes; ++node) analyse(kDown, level, node, active);
  }
}

/// Lambertian ground: I = A/π (diffuse irradiance + μs T). Order by order the irradiance is that of one order
/// less. [T4, I4]
template <class V>
void DiffuseField<V>::reflect_at_ground(LaneMask<V> active, bool by_order) {
  const V albedo = load<V>(optics_.ground_albedo);
  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V* radiance = radiance_.data() + node * directions();
    V irradiance{};
    for (int d = 0; d < directions(); ++d) irradiance += radiance[d] * grid_.flux_weight[d];
    V& kept = ground_irradiance_.data()[node];
    const V before = kept;
    kept = select<V>(active, irradiance, kept);
    const float cosine = grid_.sun_cosine[node];
    const V direct = cosine > 0.0f ? beam_.data()[node] * cosine : V{};
    const V reflected = albedo * ((by_order ? before : kept) + direct) * 0.318309886f;
    for (int d = 0; d < directions(); ++d) radiance[d] = reflected;
    analyse(kUp, 0, node, active);
  }
}

template <class V>
void DiffuseField<V>::sweep_up(LaneMask<V> active) {
  for (int sublayer = 0; sublayer < grid_.sublayers; ++sublayer) {
    transport(kUp, sublayer, sublayer, sublayer + 1);
    for (int node = 0; node < grid_.sun_nodes; ++node) analyse(kUp, sublayer + 1, node, active);
  }
}

/// The changes of successive iterations fall off like λ^n. Per lane and sun node: λ from the last two
/// changes of the moments (l <= 2, m = 0), and the error left as λ/(1-λ) times the last change. Every third
/// iteration all moments of the column are pushed on by as much as M_00 has still to go; the iteration
/// after a push has no predecessor to compare with and is not judged. [I1-I3]
/// @return lanes not yet converged
template <class V>
LaneMask<V> DiffuseField<V>::accelerate_and_test(int iteration, const IterationLimits& limits,
                                                 LaneMask<V> active) {
  const int levels = grid_.sublayers + 1;
  const bool judged = iteration > 1 && iteration % kPushEvery != 1;
  const bool pushes = iteration % kPushEvery == 0;
  LaneMask<V> open = judged ? V{} != V{} : V{} == V{};
  // From one sun node to the next no light falls off by more than a thousand, except where none is left (in
  // the night of a planet without curvature): what is below that need not settle.
  V scale{};
  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V change{};
    V size{};
    for (int level = 0; level < levels; ++level) {
      const V* down = half_[kDown].data() + moment_index(level, node);
      const V* up = half_[kUp].data() + moment_index(level, node);
      V* watched = watched_.data() + static_cast<std::size_t>(level * grid_.sun_nodes + node) * kWatched;
      size += lane_max(watched[0], -watched[0]);
      for (int i = 0; i < kWatched; ++i) {
        const V value = down[i] + up[i];
        const V step = value - watched[i];
        change += lane_max(step, -step);
        watched[i] = value;
        if (i == 0) mean_change_.data()[level * grid_.sun_nodes + node] = step;
      }
    }
    V& before = last_change_.data()[node];
    const V ratio = lane_min(select<V>(before > 0.0f, change / (before + 1e-37f), V{}), broadcast<V>(0.97f));
    const V rest = ratio / (1.0f - ratio);
    before = change;
    if (!judged) continue;
    scale = lane_max(size, scale * 1e-3f);
    open |= change * rest > scale * limits.tolerance;
    if (!pushes) continue;
    const V push = lane_min(rest, broadcast<V>(6.0f));
    for (int level = 0; level < levels; ++level) {
      V* watched = watched_.data() + static_cast<std::size_t>(level * grid_.sun_nodes + node) * kWatched;
      V gain = 1.0f + push * mean_change_.data()[level * grid_.sun_nodes + node] / (watched[0] + 1e-30f);
      gain = lane_max(lane_min(gain, broadcast<V>(2.0f)), broadcast<V>(0.5f));
      gain = select<V>(active, gain, broadcast<V>(1.0f));
      for (int half = 0; half < 2; ++half) {
        V* moment = half_[half].data() + moment_index(level, node);
        for (int i = 0; i < grid_.moments; ++i) moment[i] *= gain;
      }
      for (int i = 0; i < kWatched; ++i) watched[i] *= gain;
    }
  }
  return active & open;
}

template <class V>
void DiffuseField<V>::merge_halves() {
  const std::size_t size = count(grid_.sublayers + 1, grid_.moments);
  for (std::size_t i = 0; i < size; ++i) half_[kDown].data()[i] += half_[kUp].data()[i];
}

}  // namespace skylut::transfer
