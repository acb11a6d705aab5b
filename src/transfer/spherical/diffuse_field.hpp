#pragma once

#include "angular_sizes.hpp"
#include "azimuth_transform.hpp"
#include "convergence.hpp"
#include "horizon_light.hpp"
#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"
#include "polarised_transform.hpp"
#include "slant_depth.hpp"
#include "sweep_beam.hpp"

// Multiple scattering of one block of lanes: successive orders on short characteristics, with the moments
// of the diffuse radiance as the only unknowns. Reading order: solve, sweep_down, sweep_up, then what
// they call. [theory.md §4.3-4.5]

namespace skylut::transfer {

/// @tparam Sizes    of the angular transforms: AnySizes or FixedSizes
/// @tparam kStokes  1: I alone, of light that is taken for unpolarised; 3: I, Q, U
template <class V, class Sizes, int kStokes>
class DiffuseField {
 public:
  DiffuseField(const SweepView& grid, const Sizes& sizes, const OpticsView& optics,
               const SlantDepthToSun<V>& slant_depth)
      : grid_(grid),
        sizes_(sizes),
        optics_(optics),
        hemisphere_{LaneArray<V>(count(grid.sublayers + 1, grid.moments)),
                    LaneArray<V>(count(grid.sublayers + 1, grid.moments))},
        polarised_{LaneArray<V>(polarised_index(grid.sublayers + 1, 0)),
                   LaneArray<V>(polarised_index(grid.sublayers + 1, 0))},
        beam_(grid, optics, slant_depth),
        radiance_(kStokes * count(1, directions())),
        upwind_(kStokes * count(1, directions())),
        local_source_(kStokes * count(1, directions())),
        chords_(kStokes * count(grid.sublayers + 1, grid.chord_nodes * grid.azimuth_nodes)),
        ground_irradiance_(count(1, 1)),
        step_weights_(static_cast<std::size_t>(grid.polar_nodes)),
        scaled_moments_(static_cast<std::size_t>(grid.moments)),
        by_azimuthal_order_(static_cast<std::size_t>(grid.polar_nodes * grid.azimuthal_orders)),
        polarised_found_(static_cast<std::size_t>(2 * grid.polarised.moments)),
        polarised_transform_(grid),
        horizon_(grid, optics) {
    for (const Hemisphere hemisphere : {kDown, kUp}) {
      source_moments_[hemisphere] = hemisphere_[hemisphere].data();
      polarised_source_moments_[hemisphere] = polarised_[hemisphere].data();
    }
  }

  /// Iterates until every lane and sun node has converged (Gauss-Seidel: every step uses the newest field),
  /// or sums the orders asked for one by one (every step uses the field of one order less). [T3, I4]
  IterationReport solve(const IterationLimits& limits);

  /// Moments of the whole diffuse radiance, of both hemispheres together [level][node][moment], and diffuse
  /// irradiance of the ground [node], after solve; once each.
  LaneArray<V> take_moments() { return both_hemispheres(hemisphere_); }
  /// The same of Q and U, [level][node][Q, U][moment]; empty if kStokes is 1.
  LaneArray<V> take_polarised_moments() { return both_hemispheres(polarised_); }
  LaneArray<V> take_ground_irradiance() { return static_cast<LaneArray<V>&&>(ground_irradiance_); }
  /// What the sweep found near the ground.
  const HorizonLight<V>& horizon_light() const { return horizon_; }

 private:
  std::size_t count(int levels, int each) const {
    return static_cast<std::size_t>(levels) * static_cast<std::size_t>(grid_.sun_nodes * each);
  }
  int directions() const { return sizes_.polar_nodes * sizes_.azimuth_nodes; }
  std::size_t moment_index(int level, int node) const {
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) * static_cast<std::size_t>(grid_.moments);
  }
  std::size_t polarised_index(int level, int node) const {
    if constexpr (kStokes == 1) return 0;
    return static_cast<std::size_t>(level * grid_.sun_nodes + node) *
           static_cast<std::size_t>(2 * grid_.polarised.moments);
  }
  /// Of a Stokes parameter at the level that the sweep has reached. [direction]
  V* at_node(LaneArray<V>& light, int stokes, int node) const {
    return light.data() + (stokes * grid_.sun_nodes + node) * directions();
  }
  /// Of grazing directions at any level. [polar][azimuth]
  V* chords(int stokes, int level, int node) {
    return chords_.data() +
           static_cast<std::size_t>((stokes * (grid_.sublayers + 1) + level) * grid_.sun_nodes + node) *
               static_cast<std::size_t>(grid_.chord_nodes * sizes_.azimuth_nodes);
  }
  static LaneArray<V> both_hemispheres(LaneArray<V> (&moments)[2]) {
    for (std::size_t i = 0; i < moments[kDown].size(); ++i)
      moments[kDown].data()[i] += moments[kUp].data()[i];
    return static_cast<LaneArray<V>&&>(moments[kDown]);
  }
  V extinction(int layer) const {
    return load<V>(optics_.sweep_layers.extinction_per_km + layer * kLaneCount<V>);
  }

  void sweep_down(LaneMask<V> active);
  void reflect_at_ground(LaneMask<V> active, bool by_order);
  void sweep_up(LaneMask<V> active);
  void source(Hemisphere hemisphere, int sublayer, int level, int node, int polar_count);
  void analyse(Hemisphere hemisphere, int level, int node, LaneMask<V> active);
  void transport(Hemisphere hemisphere, int sublayer, int start_level, int end_level);

  const SweepView& grid_;
  const Sizes sizes_;
  const OpticsView& optics_;
  const V* source_moments_[2];  // that make the source: hemisphere_, or those of one order less
  const V* polarised_source_moments_[2];
  LaneArray<V> hemisphere_[2];  // moments of each hemisphere [level][node][moment]
  LaneArray<V> polarised_[2];   // of Q and U [level][node][Q, U][moment]
  SweepBeam<V> beam_;
  LaneArray<V> radiance_;      // at the level the sweep has reached [Stokes][node][direction]
  LaneArray<V> upwind_;        // interpolated in polar angle, at the start of the step
  LaneArray<V> local_source_;  // source at the end of the step, then at its start
  LaneArray<V> chords_;  // downward radiance of grazing directions [Stokes][level][node][polar][azimuth]
  LaneArray<V> ground_irradiance_;
  LaneArray<StepWeights<V>> step_weights_;  // of the sublayer being crossed [polar]
  LaneArray<V> scaled_moments_;
  LaneArray<V> by_azimuthal_order_;
  LaneArray<V> polarised_found_;
  PolarisedTransform<V> polarised_transform_;
  HorizonLight<V> horizon_;
};

template <class V, class Sizes, int kStokes>
IterationReport DiffuseField<V, Sizes, kStokes>::solve(const IterationLimits& limits) {
  IterationReport report;
  const auto stops = [&] {
    const bool asked = limits.cancelled != nullptr && limits.cancelled(limits.token);
    if (asked) report.end = IterationReport::kCancelled;
    return asked;
  };
  LaneMask<V> active = V{} == V{};
  if (limits.scattering_orders > 0) {
    LaneArray<V> previous[2] = {LaneArray<V>(hemisphere_[kDown].size()),
                                LaneArray<V>(hemisphere_[kUp].size())};
    LaneArray<V> previous_polarised[2] = {LaneArray<V>(polarised_[kDown].size()),
                                          LaneArray<V>(polarised_[kUp].size())};
    // The last order is added by the line of sight.
    for (int order = 1; order < limits.scattering_orders; ++order) {
      if (stops()) return report;
      for (const Hemisphere hemisphere : {kDown, kUp}) {
        previous[hemisphere].copy(hemisphere_[hemisphere]);
        source_moments_[hemisphere] = previous[hemisphere].data();
        previous_polarised[hemisphere].copy(polarised_[hemisphere]);
        polarised_source_moments_[hemisphere] = previous_polarised[hemisphere].data();
      }
      sweep_down(active);
      reflect_at_ground(active, true);
      sweep_up(active);
      report.iterations = order;
    }
    report.end = IterationReport::kConverged;
    return report;
  }
  Convergence<V> convergence(grid_, optics_);
  while (report.iterations < limits.max_iterations) {
    if (stops()) return report;
    ++report.iterations;
    horizon_.open(Convergence<V>::judges(report.iterations));
    sweep_down(active);
    reflect_at_ground(active, false);
    sweep_up(active);
    active = convergence.accelerate_and_test(report.iterations, limits.tolerance, hemisphere_, active);
    if (any_lane<V>(active)) continue;
    report.end = IterationReport::kConverged;
    report.error_left = convergence.error_left();
    return report;
  }
  return report;
}

/// Source J(μ,φ) of a sublayer's medium at one of its levels, in the first `polar_count` polar nodes, into
/// local_source_. J = ω/4π ∫ P(Θ) (I + beam) dΩ' with P = Σ (2l+1) χ_l P_l(cosΘ), and by the addition theorem
///   P_l(cosΘ) = Σ_m (2-δ_m0) Λ_lm(μ) Λ_lm(μ') cos m(φ-φ'),
/// so that of I only its moments M_lm count, and of the beam, c T δ(Ω'-Ω_sun), c T Λ_lm(-μs)/4π:
///   J = Σ_m (2-δ_m0) cos mφ Σ_l ω (2l+1) χ_l Λ_lm(μ) [M_lm + c T Λ_lm(-μs)/4π]. [M3, M4]
/// Of polarised light Q adds its share, and Q and U have sources of their own. [P6]
template <class V, class Sizes, int kStokes>
void DiffuseField<V, Sizes, kStokes>::source(Hemisphere hemisphere, int sublayer, int level, int node,
                                             int polar_count) {
  const int layer = grid_.layer_of_sublayer[sublayer];
  const V transmission = beam_.at(level, node) * beam_.mean_factor(sublayer, node);
  const V* down = source_moments_[kDown] + moment_index(level, node);
  const V* up = source_moments_[kUp] + moment_index(level, node);
  const float* beam_moment = grid_.beam_moment + node * grid_.moments;
  const float* factor = optics_.sweep_layers.source_factor + layer * sizes_.legendre_terms * kLaneCount<V>;
  const auto intensity = [&](int i) { return down[i] + up[i] + transmission * beam_moment[i]; };
  V* scaled = scaled_moments_.data();
  for (int i = 0; i < grid_.moments; ++i)
    scaled[i] = intensity(i) * load<V>(factor + grid_.moment_degree[i] * kLaneCount<V>);
  if constexpr (kStokes == 3) {
    const std::size_t at = polarised_index(level, node);
    polarised_transform_.scatter(
        intensity, polarised_source_moments_[kDown] + at, polarised_source_moments_[kUp] + at,
        optics_.sweep_layers.polarised_factor + layer * 3 * grid_.polarised.degrees * kLaneCount<V>, scaled);
    polarised_transform_.synthesise(hemisphere, polar_count, at_node(local_source_, 1, node),
                                    at_node(local_source_, 2, node));
  }

  const int azimuthal_orders = sizes_.azimuthal_orders;
  V* by_order = by_azimuthal_order_.data();
  sizes_.for_orders([&](auto order) {
    const int m = value_of<V>(order);
    polar_of_degrees(sizes_, order, polar_count, grid_.polar_synthesis[hemisphere][m],
                     scaled + grid_.moment_offset[m], by_order + m, azimuthal_orders);
  });
  V* to = at_node(local_source_, 0, node);
  for (int j = 0; j < polar_count; ++j)
    azimuths_of_orders(grid_, sizes_, by_order + j * azimuthal_orders, to + j * sizes_.azimuth_nodes);
}

/// Moments of one hemisphere's radiance at the level that the sweep has reached. Lanes that have
/// converged keep theirs. [M1, T3]
template <class V, class Sizes, int kStokes>
void DiffuseField<V, Sizes, kStokes>::analyse(Hemisphere hemisphere, int level, int node,
                                              LaneMask<V> active) {
  const int azimuthal_orders = sizes_.azimuthal_orders;
  const V* radiance = radiance_.data() + node * directions();
  V* by_order = by_azimuthal_order_.data();
  for (int j = 0; j < sizes_.polar_nodes; ++j)
    orders_of_azimuths(grid_, sizes_, radiance + j * sizes_.azimuth_nodes, by_order + j * azimuthal_orders);
  horizon_.keep(hemisphere, level, node, active, by_order);
  V* found = scaled_moments_.data();
  sizes_.for_orders([&](auto order) {
    const int m = value_of<V>(order);
    degrees_of_polar(sizes_, order, grid_.polar_analysis[hemisphere][m], by_order + m, azimuthal_orders,
                     found + grid_.moment_offset[m]);
  });
  V* kept = hemisphere_[hemisphere].data() + moment_index(level, node);
  for (int i = 0; i < grid_.moments; ++i) kept[i] = select<V>(active, found[i], kept[i]);
  if constexpr (kStokes == 3) {
    V* polarised = polarised_found_.data();
    polarised_transform_.analyse(hemisphere, at_node(radiance_, 1, node), at_node(radiance_, 2, node),
                                 polarised);
    V* to = polarised_[hemisphere].data() + polarised_index(level, node);
    for (int i = 0; i < 2 * grid_.polarised.moments; ++i) to[i] = select<V>(active, polarised[i], to[i]);
  }
}

/// Carries radiance_ across a sublayer. Along a ray dI/dt = J - I, so that over a step of optical depth t
///   I_end = e^-t I_start + ∫₀ᵗ J(t') e^-(t-t') dt' = e^-t I_start + upwind J_start + local J_end
/// for a J linear in optical depth (StepWeights). What stands at the start, e^-t I + upwind J, is
/// interpolated there in polar angle, then in solar zenith angle, since the sun stands otherwise where the
/// ray started. The azimuth is kept: over one step it turns by less than what the nodes resolve. [T1, T2]
template <class V, class Sizes, int kStokes>
void DiffuseField<V, Sizes, kStokes>::transport(Hemisphere hemisphere, int sublayer, int start_level,
                                                int end_level) {
  const int azimuths = sizes_.azimuth_nodes;
  const V beta = extinction(grid_.layer_of_sublayer[sublayer]);
  const PolarStep* steps = grid_.polar_step[hemisphere] + sublayer * sizes_.polar_nodes;
  int chord_count = 0;
  for (int j = 0; j < sizes_.polar_nodes; ++j) {
    step_weights_.data()[j] = step_weights(beta * steps[j].length_km);
    if (steps[j].chord) chord_count = j + 1;
  }

  for (int node = 0; node < grid_.sun_nodes; ++node) {
    source(hemisphere, sublayer, start_level, node, sizes_.polar_nodes);
    for (int stokes = 0; stokes < kStokes; ++stokes) {
      const V* start_source = at_node(local_source_, stokes, node);
      const V* radiance = at_node(radiance_, stokes, node);
      V* upwind = at_node(upwind_, stokes, node);
      for (int j = chord_count; j < sizes_.polar_nodes; ++j) {
        const StepWeights<V>& weights = step_weights_.data()[j];
        const InterpolationWeights& nodes = steps[j].upwind;
        V transmitted[4];
        V emitted[4];
        for (int t = 0; t < 4; ++t) {
          transmitted[t] = weights.transmission * nodes.weight[t];
          emitted[t] = weights.upwind * nodes.weight[t];
        }
        const V* from = radiance + nodes.first * azimuths;
        const V* made = start_source + nodes.first * azimuths;
        for (int k = 0; k < azimuths; ++k) {
          V sum{};
          for (int t = 0; t < 4; ++t)
            sum += transmitted[t] * from[t * azimuths + k] + emitted[t] * made[t * azimuths + k];
          upwind[j * azimuths + k] = sum;
        }
      }
    }
    if (chord_count == 0) continue;
    // A chord entered downwards through the level where it leaves.
    source(kDown, sublayer, end_level, node, chord_count);
    for (int stokes = 0; stokes < kStokes; ++stokes) {
      const V* start_source = at_node(local_source_, stokes, node);
      const V* entered = chords(stokes, end_level, node);
      V* upwind = at_node(upwind_, stokes, node);
      for (int j = 0; j < chord_count; ++j)
        for (int d = j * azimuths; d < (j + 1) * azimuths; ++d)
          upwind[d] = step_weights_.data()[j].transmission * entered[d] +
                      step_weights_.data()[j].upwind * start_source[d];
    }
  }

  for (int node = 0; node < grid_.sun_nodes; ++node) {
    source(hemisphere, sublayer, end_level, node, sizes_.polar_nodes);
    const InterpolationWeights* suns =
        grid_.sun_weights[hemisphere] +
        static_cast<std::size_t>(sublayer * grid_.sun_nodes + node) * static_cast<std::size_t>(directions());
    for (int stokes = 0; stokes < kStokes; ++stokes) {
      const V* end_source = at_node(local_source_, stokes, node);
      const V* upwind = at_node(upwind_, stokes, 0);
      V* radiance = at_node(radiance_, stokes, node);
      for (int j = 0; j < sizes_.polar_nodes; ++j) {
        const V local = step_weights_.data()[j].local;
        for (int d = j * azimuths; d < (j + 1) * azimuths; ++d) {
          const V* from = upwind + suns[d].first * directions() + d;
          V sum = local * end_source[d];
          for (int t = 0; t < 4; ++t) sum += from[t * directions()] * suns[d].weight[t];
          radiance[d] = sum;
        }
      }
    }
  }
}

template <class V, class Sizes, int kStokes>
void DiffuseField<V, Sizes, kStokes>::sweep_down(LaneMask<V> active) {
  radiance_.fill(V{});  // nothing but the beam enters at the top
  const int chord_directions = grid_.chord_nodes * sizes_.azimuth_nodes;
  for (int level = grid_.sublayers - 1; level >= -1; --level) {
    for (int stokes = 0; stokes < kStokes; ++stokes)
      for (int node = 0; node < grid_.sun_nodes; ++node) {
        V* kept = chords(stokes, level + 1, node);
        const V* radiance = at_node(radiance_, stokes, node);
        for (int d = 0; d < chord_directions; ++d) kept[d] = radiance[d];
      }
    if (level < 0) break;
    transport(kDown, level, level + 1, level);
    for (int node = 0; node < grid_.sun_nodes; ++node) analyse(kDown, level, node, active);
  }
}

/// Lambertian ground, which leaves nothing polarised: I = A/π (diffuse irradiance + μs T). Order by order the
/// irradiance is that of one order less. [T4, I4]
template <class V, class Sizes, int kStokes>
void DiffuseField<V, Sizes, kStokes>::reflect_at_ground(LaneMask<V> active, bool by_order) {
  const V albedo = load<V>(optics_.ground_albedo);
  for (int node = 0; node < grid_.sun_nodes; ++node) {
    V* radiance = radiance_.data() + node * directions();
    V irradiance{};
    for (int d = 0; d < directions(); ++d) irradiance += radiance[d] * grid_.flux_weight[d];
    V& kept = ground_irradiance_.data()[node];
    const V before = kept;
    kept = select<V>(active, irradiance, kept);
    const float cosine = grid_.sun_cosine[node];
    const V direct = cosine > 0.0f ? beam_.at(0, node) * cosine : V{};
    const V reflected = albedo * ((by_order ? before : kept) + direct) * kInversePi;
    for (int d = 0; d < directions(); ++d) radiance[d] = reflected;
    for (int stokes = 1; stokes < kStokes; ++stokes)
      for (int d = 0; d < directions(); ++d) at_node(radiance_, stokes, node)[d] = V{};
    analyse(kUp, 0, node, active);
  }
}

template <class V, class Sizes, int kStokes>
void DiffuseField<V, Sizes, kStokes>::sweep_up(LaneMask<V> active) {
  for (int sublayer = 0; sublayer < grid_.sublayers; ++sublayer) {
    transport(kUp, sublayer, sublayer, sublayer + 1);
    for (int node = 0; node < grid_.sun_nodes; ++node) analyse(kUp, sublayer + 1, node, active);
  }
}

}  // namespace skylut::transfer
