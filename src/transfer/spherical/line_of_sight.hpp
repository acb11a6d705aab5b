#pragma once

#include "diffuse_field.hpp"

// Radiance along one line of sight for all suns and azimuths that share it: the diffuse field's source by
// its moments, and the sun's single scattering exactly. [theory.md §4.6, L1-L4]

namespace skylut::transfer {

/// Optical depth between a point and the sun, on exact shell paths. With p the distance of the sunbeam's
/// line from the planet's centre and s_h = √(r_h² - p²), a layer's path is s_top - s_bottom, formed as
/// (r_top² - r_bottom²)/(s_top + s_bottom) so that single precision keeps all its digits. [G2-G4]
template <class V>
inline V depth_to_sun(const RayView& ray, const OpticsView& optics, int layers, float altitude_km,
                      float perigee_km, bool down) {
  constexpr int kMostLayers = 256;
  float length[kMostLayers];
  const float twice_radius = 2.0f * ray.planet_radius_km;
  const float* level = ray.level_altitude_km;
  const float lowest = down ? perigee_km : altitude_km;
  const auto from_perigee = [&](float h) {
    return __builtin_sqrtf((h - perigee_km) * (twice_radius + h + perigee_km));
  };
  for (int layer = 0; layer < layers; ++layer) {
    const float lower = level[layer] > lowest ? level[layer] : lowest;
    const float upper = level[layer + 1] > lowest ? level[layer + 1] : lowest;
    const float gained = (upper - lower) * (twice_radius + upper + lower);
    length[layer] = gained / (from_perigee(upper) + from_perigee(lower) + 1e-20f);
  }
  if (down)
    for (int layer = 0; layer < layers; ++layer) {
      // The way down to the perigee crosses the layers below the point a second time.
      float lower = level[layer] > lowest ? level[layer] : lowest;
      float upper = level[layer + 1] > lowest ? level[layer + 1] : lowest;
      lower = lower < altitude_km ? lower : altitude_km;
      upper = upper < altitude_km ? upper : altitude_km;
      const float gained = (upper - lower) * (twice_radius + upper + lower);
      length[layer] += gained / (from_perigee(upper) + from_perigee(lower) + 1e-20f);
    }
  // Four running sums, because each addition waits for the one before it.
  V sum[4] = {};
  int layer = 0;
  const auto term = [&](int at) {
    return load<V>(optics.layers.extinction_per_km + at * kLaneCount<V>) * length[at];
  };
  while (layer < layers && level[layer + 1] <= lowest) ++layer;
  for (; layer + 4 <= layers; layer += 4)
    for (int i = 0; i < 4; ++i) sum[i] += term(layer + i);
  for (; layer < layers; ++layer) sum[0] += term(layer);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// The diffuse field after the iteration.
template <class V>
struct Solution {
  const SweepView& grid;
  LaneArray<V> moment;             // [level][node][moment]
  LaneArray<V> ground_irradiance;  // diffuse [node]

  const V* moments(int level, int node) const {
    return moment.data() +
           static_cast<std::size_t>(level * grid.sun_nodes + node) * static_cast<std::size_t>(grid.moments);
  }
};

/// Mean of e^-a over a step in which a goes linearly from a0 to a1: (e^-a0 - e^-a1)/(a1 - a0), as its
/// series in a1 - a0 where the difference is small (remainder 0.5^7/8! = 2e-7). [L2]
template <class V>
inline V mean_attenuation(V a0, V a1, V exp_a0, V exp_a1) {
  const V t = a1 - a0;
  constexpr float kSeries[] = {1.0f, -0.5f, 1.0f / 6.0f, -1.0f / 24.0f, 1.0f / 120.0f, -1.0f / 720.0f};
  V series = broadcast<V>(1.0f / 5040.0f);
  for (int i = 5; i >= 0; --i) series = series * t + kSeries[i];
  const LaneMask<V> small = lane_max(t, -t) < 0.5f;
  return select<V>(small, exp_a0 * series, (exp_a0 - exp_a1) / select<V>(small, broadcast<V>(1.0f), t));
}

/// Scratch space of line_of_sight, reused from ray to ray.
template <class V>
struct RayScratch {
  RayScratch(int segments, int pairs, int sun_nodes, int orders)
      : depth(static_cast<std::size_t>(segments + 1)),
        source_orders(static_cast<std::size_t>(sun_nodes * orders)),
        near_source(static_cast<std::size_t>(pairs)),
        far_source(static_cast<std::size_t>(pairs)),
        radiance(static_cast<std::size_t>(pairs)) {}
  LaneArray<V> depth;  // from the observer to each segment's near end
  LaneArray<V> source_orders;
  LaneArray<V> near_source;
  LaneArray<V> far_source;
  LaneArray<V> radiance;
};

/// Source of the diffuse field in the direction of the ray at one end of a segment, for every pair.
/// [M3, L3]
template <class V>
inline void ray_source(const SweepView& grid, const OpticsView& optics, const RayView& ray,
                       const Solution<V>& field, int segment, bool far, V* source_orders, V* to) {
  const RaySegment& part = ray.segment[segment];
  const int end = 2 * segment + (far ? 1 : 0);
  const float fraction = far ? part.far_fraction : part.near_fraction;
  const float* polar =
      ray.polar_moment + static_cast<std::size_t>(end) * static_cast<std::size_t>(grid.moments);
  const RaySource* sources = ray.source + static_cast<std::size_t>(end) * static_cast<std::size_t>(ray.pairs);
  const float* azimuths =
      ray.azimuth_factor +
      static_cast<std::size_t>(end) * static_cast<std::size_t>(ray.pairs * grid.azimuthal_orders);
  const float* factor = optics.sweep_layers.source_factor +
                        grid.layer_of_sublayer[part.sublayer] * grid.degrees * kLaneCount<V>;

  bool wanted[128] = {};
  for (int pair = 0; pair < ray.pairs; ++pair)
    for (int t = 0; t < 4; ++t) wanted[sources[pair].first_node + t] = true;
  for (int node = 0; node < grid.sun_nodes; ++node) {
    if (!wanted[node]) continue;
    const V* lower = field.moments(part.sublayer, node);
    const V* upper = field.moments(part.sublayer + 1, node);
    for (int m = 0; m < grid.azimuthal_orders; ++m) {
      V sum{};
      for (int i = grid.moment_offset[m]; i < grid.moment_offset[m + 1]; ++i)
        sum += load<V>(factor + grid.moment_degree[i] * kLaneCount<V>) * polar[i] *
               (lower[i] * (1.0f - fraction) + upper[i] * fraction);
      source_orders[node * grid.azimuthal_orders + m] = sum;
    }
  }
  for (int pair = 0; pair < ray.pairs; ++pair) {
    const float* azimuth = azimuths + pair * grid.azimuthal_orders;
    V sum{};
    for (int t = 0; t < 4; ++t) {
      const V* order = source_orders + (sources[pair].first_node + t) * grid.azimuthal_orders;
      V at_node{};
      for (int m = 0; m < grid.azimuthal_orders; ++m) at_node += order[m] * azimuth[m];
      sum += at_node * sources[pair].node_weight[t];
    }
    to[pair] = sum;
  }
}

/// Single scattering of the sun along the ray for one pair. [L1]
template <class V>
inline V single_scattering(const SweepView& grid, const OpticsView& optics, const RayView& ray,
                           const float* phases, const V* depth, int pair) {
  const float* phase = phases + static_cast<std::size_t>(pair * optics.scatterers) * kLaneCount<V>;
  V sum{};
  V far_depth{};
  V far_attenuation{};
  for (int part = ray.first_lit[pair]; part < ray.first_lit[pair + 1]; ++part) {
    const LitPart& lit = ray.lit[part];
    const int layer = ray.segment[lit.segment].layer;
    const V beta = load<V>(optics.layers.extinction_per_km + layer * kLaneCount<V>);
    V scattering{};
    for (int s = 0; s < optics.scatterers; ++s)
      scattering += load<V>(optics.scattering_per_km + (s * grid.layers + layer) * kLaneCount<V>) *
                    load<V>(phase + s * kLaneCount<V>);
    const V near_ray_depth = depth[lit.segment] + beta * lit.start_km;
    if (!lit.continues) {
      far_depth = near_ray_depth + depth_to_sun<V>(ray, optics, grid.layers, lit.near_altitude_km,
                                                   lit.near_perigee_km, lit.near_down);
      far_attenuation = exp_minus(far_depth);
    }
    const V near_depth = far_depth;
    const V near_attenuation = far_attenuation;
    far_depth =
        near_ray_depth + beta * lit.length_km +
        depth_to_sun<V>(ray, optics, grid.layers, lit.far_altitude_km, lit.far_perigee_km, lit.far_down);
    far_attenuation = exp_minus(far_depth);
    sum += scattering * mean_attenuation(near_depth, far_depth, near_attenuation, far_attenuation) *
           lit.length_km;
  }
  return sum * 0.0795774715f;  // 1/4π
}

/// Radiance of the ray for every pair: out[pair], sr⁻¹. [L1 + L3 + L4]
template <class V>
inline void line_of_sight(const SweepView& grid, const OpticsView& optics, const RayView& ray,
                          const float* phases, const Solution<V>& field, RayScratch<V>& scratch, V* out) {
  V* depth = scratch.depth.data();
  depth[0] = V{};
  for (int segment = 0; segment < ray.segments; ++segment) {
    const int layer = ray.segment[segment].layer;
    depth[segment + 1] = depth[segment] + load<V>(optics.layers.extinction_per_km + layer * kLaneCount<V>) *
                                              ray.segment[segment].length_km;
  }
  for (int pair = 0; pair < ray.pairs; ++pair)
    out[pair] = single_scattering(grid, optics, ray, phases, depth, pair);

  V* near_source = scratch.near_source.data();
  V* far_source = scratch.far_source.data();
  int known_layer = -1;
  for (int segment = 0; segment < ray.segments; ++segment) {
    // The source changes only from one layer of the sweep to the next; within one, the far end of a segment
    // is the near end of the next.
    const int layer = grid.layer_of_sublayer[ray.segment[segment].sublayer];
    if (layer == known_layer) {
      V* const swap = near_source;
      near_source = far_source;
      far_source = swap;
    } else {
      ray_source(grid, optics, ray, field, segment, false, scratch.source_orders.data(), near_source);
    }
    ray_source(grid, optics, ray, field, segment, true, scratch.source_orders.data(), far_source);
    known_layer = layer;
    const StepWeights<V> weights = step_weights(depth[segment + 1] - depth[segment]);
    // The medium's own layer may absorb more or less than the merged layer that it is part of.
    const V own_albedo =
        load<V>(optics.layers.source_factor + ray.segment[segment].layer * grid.degrees * kLaneCount<V>);
    const V merged_albedo = load<V>(optics.sweep_layers.source_factor + layer * grid.degrees * kLaneCount<V>);
    const V transmission = exp_minus(depth[segment]) * own_albedo / (merged_albedo + 1e-30f);
    for (int pair = 0; pair < ray.pairs; ++pair)
      out[pair] += transmission * (weights.local * near_source[pair] + weights.upwind * far_source[pair]);
  }

  if (!ray.hits_ground) return;
  const V transmission = exp_minus(depth[ray.segments]);
  const V albedo = load<V>(optics.ground_albedo);
  const RaySource* sources = ray.ground_source;
  for (int pair = 0; pair < ray.pairs; ++pair) {
    V irradiance{};
    for (int t = 0; t < 4; ++t)
      irradiance +=
          field.ground_irradiance.data()[sources[pair].first_node + t] * sources[pair].node_weight[t];
    if (ray.ground_sun_cosine[pair] > 0.0f)
      irradiance +=
          exp_minus(depth_to_sun<V>(ray, optics, grid.layers, 0.0f, ray.ground_perigee_km[pair], false)) *
          ray.ground_sun_cosine[pair];
    out[pair] += transmission * albedo * irradiance * 0.318309886f;
  }
}

template <class V>
class SolvedLanes final : public SolvedBlock {
 public:
  SolvedLanes(const SweepView& grid, const OpticsView& optics, DiffuseField<V>& field)
      : optics_(optics), solution_{grid, field.take_moments(), field.take_ground_irradiance()} {}

  void line_of_sight(const RayView& ray, const float* phase, float* radiance) const override {
    const SweepView& grid = solution_.grid;
    RayScratch<V> scratch(ray.segments, ray.pairs, grid.sun_nodes, grid.azimuthal_orders);
    transfer::line_of_sight(grid, optics_, ray, phase, solution_, scratch, scratch.radiance.data());
    __builtin_memcpy(radiance, scratch.radiance.data(), static_cast<std::size_t>(ray.pairs) * sizeof(V));
  }

 private:
  OpticsView optics_;
  Solution<V> solution_;
};

template <class V>
inline SolvedBlock* solve_block(const SweepView& grid, const OpticsView& optics,
                                const IterationLimits& limits) {
  DiffuseField<V> field(grid, optics);
  return field.solve(limits) ? new SolvedLanes<V>(grid, optics, field) : nullptr;
}

}  // namespace skylut::transfer
