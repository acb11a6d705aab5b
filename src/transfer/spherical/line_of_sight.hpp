#pragma once

#include "horizon_light.hpp"
#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"
#include "ray_scratch.hpp"
#include "slant_depth.hpp"

// What a line of sight collects, for all suns and azimuths that share it: the sun's single scattering, the
// diffuse field's source by its moments, the ground at its end. As in lanes.hpp, templates only.
// [theory.md §4.6, L1-L5]

namespace skylut::transfer {

/// The diffuse field after the iteration.
template <class V>
struct Solution {
  const SweepView& grid;
  LaneArray<V> moment;             // [level][node][moment]
  LaneArray<V> polarised_moment;   // [level][node][Q, U][moment]; empty where light is unpolarised
  LaneArray<V> ground_irradiance;  // diffuse [node]
  HorizonDeficit<V> horizon;

  const V* moments(int level, int node) const {
    return moment.data() +
           static_cast<std::size_t>(level * grid.sun_nodes + node) * static_cast<std::size_t>(grid.moments);
  }
  const V* polarised_moments(int level, int node) const {
    return polarised_moment.data() + static_cast<std::size_t>(level * grid.sun_nodes + node) *
                                         static_cast<std::size_t>(2 * grid.polarised.moments);
  }
};

/// Mean of e^-a over a step in which a goes linearly from a0 to a1: with t = a1 - a0 that is
/// e^-(a0+a1)/2 sinh(t/2)/(t/2), by its series where |t| < 3 (remainder 1.5^10/11! = 1.4e-6), otherwise
/// (e^-a0 - e^-a1)/t. [L2]
template <class V>
inline V mean_attenuation(V a0, V a1) {
  const V t = a1 - a0;
  const V square = t * t;
  V series = square * (1.0f / 92897280.0f) + 1.0f / 322560.0f;
  series = series * square + 1.0f / 1920.0f;
  series = series * square + 1.0f / 24.0f;
  series = series * square + 1.0f;
  const V mean = exp_minus(0.5f * (a0 + a1)) * series;
  const LaneMask<V> steep = square >= 9.0f;
  if (!any_lane<V>(steep)) return mean;
  return select<V>(steep, (exp_minus(a0) - exp_minus(a1)) / select<V>(steep, t, broadcast<V>(1.0f)), mean);
}

/// Goes along the lit parts of the line for all pairs. A point at the distance s scatters the beam that
/// reaches it, e^-τ(point to sun), and e^-τ(observer to point) of that arrives; on a lit part the sum of both
/// depths goes linearly from one end to the other (mean_attenuation). Segment by segment, so that what the
/// pairs look up of the sun's depth lies close together. [L2]
/// @param visit  (lit part, layer, mean attenuation, depth of the forward peak on the whole way: a function)
template <class V, class Visit>
inline void along_lit_parts(const OpticsView& optics, const RayView& ray,
                            const SlantDepthToSun<V>& slant_depth, const SlantDepthToSun<V>& slant_peak_depth,
                            RayScratch<V>& scratch, const Visit& visit) {
  V* const far_depth = scratch.far_depth.data();
  V depth{};
  V peak_depth{};
  for (int segment = 0; segment < ray.segments; ++segment) {
    const int layer = ray.segment[segment].layer;
    const V beta = load<V>(optics.layers.extinction_per_km + layer * kLaneCount<V>);
    const V peak = load<V>(optics.peak_per_km + layer * kLaneCount<V>);
    for (int part = ray.first_lit[segment]; part < ray.first_lit[segment + 1]; ++part) {
      const LitPart& lit = ray.lit[part];
      const SlantDepthWeights& far_end = ray.lit_end[lit.near_end + 1];
      const auto peak_on_the_way = [&] {
        return peak_depth + peak * (lit.start_km + lit.length_km) + slant_peak_depth(far_end);
      };
      const V start_depth = depth + beta * lit.start_km;
      const V near_depth =
          lit.continues ? far_depth[lit.pair] : start_depth + slant_depth(ray.lit_end[lit.near_end]);
      const V end_depth = start_depth + beta * lit.length_km + slant_depth(far_end);
      far_depth[lit.pair] = end_depth;
      visit(lit, layer, mean_attenuation(near_depth, end_depth), peak_on_the_way);
    }
    depth += beta * ray.segment[segment].length_km;
    peak_depth += peak * ray.segment[segment].length_km;
  }
}

/// Depth of the forward peak as the correction's series, which has two terms, takes it. [L5]
template <class V>
inline V series_depth(V peak_depth) {
  return lane_min(peak_depth, broadcast<V>(1.0f));
}

/// What the medium's scattering towards the sun's neighbourhood gains and loses because the truncated peak
/// spreads the light by `peak_depth`, the depth of the peak on the whole way. [L5]
template <class V>
inline V spread_scattering(const float* scattering_per_km, std::ptrdiff_t stride, const float* peaks,
                           int scatterers, V peak_depth) {
  const V m = series_depth(peak_depth);
  V gained{};
  for (int s = 0; s < scatterers; ++s)
    gained +=
        load<V>(scattering_per_km + s * stride) *
        (load<V>(peaks + (scatterers + s) * kLaneCount<V>) * (0.5f * m) - load<V>(peaks + s * kLaneCount<V>));
  return gained * m;
}

/// Single scattering of the sun for all pairs: every point scatters β_sca P(Θ)/4π of the beam towards the
/// observer, Θ being the same all along a straight ray:
///   I₁ = (1/4π) Σ_i P_i(Θ) ∫ β_sca,i e^-a ds,  a = τ(observer to point) + τ(point to sun). [L1, L5]
/// @param peaks  null: the forward peaks are left as they are
template <class V>
inline void single_scattering(const SweepView& grid, const OpticsView& optics, const RayView& ray,
                              const float* phases, const float* peaks, const SlantDepthToSun<V>& slant_depth,
                              const SlantDepthToSun<V>& slant_peak_depth, RayScratch<V>& scratch, V* out) {
  const std::ptrdiff_t stride = grid.slant_depth.layers * kLaneCount<V>;
  along_lit_parts(optics, ray, slant_depth, slant_peak_depth, scratch,
                  [&](const LitPart& lit, int layer, V attenuation, const auto& peak_on_the_way) {
                    const float* scattering_per_km = optics.scattering_per_km + layer * kLaneCount<V>;
                    const float* phase = phases + lit.pair * optics.scatterers * kLaneCount<V>;
                    V scattering{};
                    for (int s = 0; s < optics.scatterers; ++s)
                      scattering +=
                          load<V>(scattering_per_km + s * stride) * load<V>(phase + s * kLaneCount<V>);
                    if (peaks != nullptr && ray.aureole[lit.pair] >= 0)
                      scattering += spread_scattering(
                          scattering_per_km, stride,
                          peaks + ray.aureole[lit.pair] * 2 * optics.scatterers * kLaneCount<V>,
                          optics.scatterers, peak_on_the_way());
                    out[lit.pair] += scattering * attenuation * (lit.length_km * kInverseFourPi);
                  });
}

/// The same without the phase functions, scatterer by scatterer: the amplitudes that P_i(Θ) and the forward
/// peak's two coefficients multiply,
///   A_i = (1/4π) ∫ β_sca,i e^-a ds,  B_i = (1/4π) ∫ β_sca,i m e^-a ds,  C_i = (1/4π) ∫ β_sca,i m²/2 e^-a ds,
///   I₁ = Σ_i P_i A_i - Q1_i B_i + Q2_i C_i.
/// They are smooth in direction where the phase functions are not. [L1, L5]
/// @param out  [A, B, C][scatterer][pair]
template <class V>
inline void single_scattering_amplitudes(const SweepView& grid, const OpticsView& optics, const RayView& ray,
                                         const SlantDepthToSun<V>& slant_depth,
                                         const SlantDepthToSun<V>& slant_peak_depth, RayScratch<V>& scratch,
                                         V* out) {
  const std::ptrdiff_t stride = grid.slant_depth.layers * kLaneCount<V>;
  const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(optics.scatterers) * ray.pairs;
  along_lit_parts(optics, ray, slant_depth, slant_peak_depth, scratch,
                  [&](const LitPart& lit, int layer, V attenuation, const auto& peak_on_the_way) {
                    const float* scattering_per_km = optics.scattering_per_km + layer * kLaneCount<V>;
                    const V m = series_depth(peak_on_the_way());
                    const V reached = attenuation * (lit.length_km * kInverseFourPi);
                    for (int s = 0; s < optics.scatterers; ++s) {
                      V* const amplitude = out + static_cast<std::ptrdiff_t>(s) * ray.pairs + lit.pair;
                      const V scattered = load<V>(scattering_per_km + s * stride) * reached;
                      amplitude[0] += scattered;
                      amplitude[next] += scattered * m;
                      amplitude[2 * next] += scattered * (0.5f * m * m);
                    }
                  });
}

/// What every source point's moments of each degree contribute to the radiance: ω (2l+1) χ_l of the medium's
/// own layers, weighted by the formal solution over every piece, in which the moments go linearly from one
/// source point to the next; and what their deficits at the horizon contribute. [T1, L3, L6]
template <class V>
inline void weigh_sources(const SweepView& grid, const OpticsView& optics, const RaySourcesView& diffuse,
                          RayScratch<V>& scratch) {
  LaneArray<V>& degree_weight = scratch.degree_weight;
  LaneArray<V>& peak_weight = scratch.peak_weight;
  degree_weight.fill(V{});
  peak_weight.fill(V{});
  V depth{};
  for (int i = 0; i < diffuse.pieces; ++i) {
    const SourcePiece& piece = diffuse.piece[i];
    const V step = load<V>(optics.layers.extinction_per_km + piece.layer * kLaneCount<V>) * piece.length_km;
    const StepWeights<V> weights = step_weights(step);
    const V transmission = exp_minus(depth);
    const V near = transmission * (weights.local * (1.0f - piece.near_fraction) +
                                   weights.upwind * (1.0f - piece.far_fraction));
    const V far = transmission * (weights.local * piece.near_fraction + weights.upwind * piece.far_fraction);
    const float* factor = optics.layers.source_factor + piece.layer * grid.legendre_terms * kLaneCount<V>;
    V* const at_near = degree_weight.data() + piece.source * grid.legendre_terms;
    V* const at_far = at_near + grid.legendre_terms;
    for (int l = 0; l < grid.legendre_terms; ++l) {
      at_near[l] += near * load<V>(factor + l * kLaneCount<V>);
      at_far[l] += far * load<V>(factor + l * kLaneCount<V>);
    }
    const int elements = 3 * grid.polarised.degrees;
    V* const polarised = scratch.polarised_weight.data() + piece.source * elements;
    for (int e = 0; e < elements; ++e) {
      const V matrix = load<V>(optics.layers.polarised_factor + (piece.layer * elements + e) * kLaneCount<V>);
      polarised[e] += near * matrix;
      polarised[elements + e] += far * matrix;
    }
    if (diffuse.horizon[piece.source].near || diffuse.horizon[piece.source + 1].near) {
      const V peak = load<V>(optics.peak_per_km + piece.layer * kLaneCount<V>) * piece.length_km;
      const V share = peak / lane_max(step + peak, broadcast<V>(1e-30f));
      peak_weight.data()[piece.source] += near * share;
      peak_weight.data()[piece.source + 1] += far * share;
    }
    depth += step;
  }
}

/// Σ_l w_lm M_lm for every azimuthal order, under several neighbouring sun nodes at a time, whose sums run
/// beside each other while each waits for its last addition.
template <class V, std::size_t kNodes>
inline void orders_under_nodes(const SweepView& grid, const V* weight, const V* moments, V* orders) {
  for (int m = 0; m < grid.azimuthal_orders; ++m) {
    V sum[kNodes] = {};
    for (int i = grid.moment_offset[m]; i < grid.moment_offset[m + 1]; ++i)
      for (std::size_t node = 0; node < kNodes; ++node)
        sum[node] += weight[i] * moments[static_cast<int>(node) * grid.moments + i];
    for (std::size_t node = 0; node < kNodes; ++node)
      orders[static_cast<int>(node) * grid.azimuthal_orders + m] = sum[node];
  }
}

/// Contribution of one source point before its azimuth is known: azimuthal orders under the wanted sun nodes.
/// [M3]
template <class V>
inline void source_azimuthal_orders(const SweepView& grid, const RaySourcesView& diffuse,
                                    const Solution<V>& field, int at, RayScratch<V>& scratch) {
  const SourcePoint& source = diffuse.source[at];
  const float* polar = diffuse.polar_moment + at * grid.moments;
  const V* degree = scratch.degree_weight.data() + at * grid.legendre_terms;
  V* const direction = scratch.direction_weight.data();
  for (int i = 0; i < grid.moments; ++i) direction[i] = degree[grid.moment_degree[i]] * polar[i];
  PolarisedSource<V>& polarised = scratch.polarised_source;
  if (polarised.wanted()) {
    const int first = at * grid.polarised.moments;
    const bool all = RayScratch<V>::stokes_of(diffuse) == 3;
    polarised.weigh(polar, all ? diffuse.rotation[0] + first : nullptr,
                    all ? diffuse.rotation[1] + first : nullptr,
                    scratch.polarised_weight.data() + at * 3 * grid.polarised.degrees);
  }

  const bool between = source.fraction > 0.0f && source.fraction < 1.0f;
  const int level = source.fraction < 1.0f ? source.sublayer : source.sublayer + 1;
  const bool grazes = field.horizon.wanted() && diffuse.horizon[at].near;
  V* const upper = scratch.upper_orders.data();
  for (int node = 0, count; node < grid.sun_nodes; node += count) {
    count = 1;
    if (!scratch.node_use.data()[node].wanted) continue;
    while (count < 4 && node + count < grid.sun_nodes && scratch.node_use.data()[node + count].wanted)
      ++count;
    V* orders = scratch.source_azimuthal_orders.data() + node * grid.azimuthal_orders;
    const auto find = [&](int at_level, V* to) {
      const V* moments = field.moments(at_level, node);
      if (count == 4)
        orders_under_nodes<V, 4>(grid, direction, moments, to);
      else if (count == 3)
        orders_under_nodes<V, 3>(grid, direction, moments, to);
      else if (count == 2)
        orders_under_nodes<V, 2>(grid, direction, moments, to);
      else
        orders_under_nodes<V, 1>(grid, direction, moments, to);
      for (int i = 0; polarised.wanted() && i < count; ++i)
        polarised.add_to_intensity(field.polarised_moments(at_level, node + i),
                                   to + i * grid.azimuthal_orders);
    };
    find(level, orders);
    if (between) {
      find(level + 1, upper);
      for (int i = 0; i < count * grid.azimuthal_orders; ++i)
        orders[i] += (upper[i] - orders[i]) * source.fraction;
    }
    for (int i = 0; grazes && i < count; ++i)
      field.horizon.add(diffuse.horizon[at], node + i, scratch.peak_weight.data()[at],
                        orders + i * grid.azimuthal_orders);
    if (RayScratch<V>::stokes_of(diffuse) == 1) continue;
    for (int i = node; i < node + count; ++i) {
      const int size = grid.polarised.orders;
      V* const q = scratch.polarised_orders.data() + i * size;
      V* const u = q + grid.sun_nodes * size;
      polarised.find(field.moments(level, i), field.polarised_moments(level, i), q, u);
      if (!between) continue;
      V* const upper_q = scratch.upper_polarised_orders.data();
      V* const upper_u = upper_q + size;
      polarised.find(field.moments(level + 1, i), field.polarised_moments(level + 1, i), upper_q, upper_u);
      for (int m = 0; m < size; ++m) {
        q[m] += (upper_q[m] - q[m]) * source.fraction;
        u[m] += (upper_u[m] - u[m]) * source.fraction;
      }
    }
  }
}

/// Adds the light of one source point to every pair's radiance. [L3]
template <class V>
inline void add_source_light(const SweepView& grid, const RayView& ray, const RaySourcesView& diffuse,
                             const Solution<V>& field, int at, RayScratch<V>& scratch, V* out) {
  const int stride = grid.azimuthal_orders;
  const InterpolationWeights* suns = diffuse.sun_weights[at];
  const float* azimuth = diffuse.azimuth_factor[at];
  scratch.node_use.fill({});
  for (int pair = 0; pair < ray.pairs; ++pair)
    for (int t = 0; t < 4; ++t) scratch.node_use.data()[suns[pair].first + t].wanted = true;
  source_azimuthal_orders(grid, diffuse, field, at, scratch);
  for (int pair = 0; pair < ray.pairs; ++pair, azimuth += diffuse.azimuth_stride) {
    const V* order = scratch.source_azimuthal_orders.data() + suns[pair].first * stride;
    V at_node[4] = {};
    for (int m = 0; m < stride; ++m)
      for (int t = 0; t < 4; ++t) at_node[t] += order[t * stride + m] * azimuth[m];
    for (int t = 0; t < 4; ++t) out[pair] += at_node[t] * suns[pair].weight[t];
  }
  if (RayScratch<V>::stokes_of(diffuse) == 3)
    add_polarised_light(grid, ray.pairs, suns, diffuse.azimuth_factor[at], diffuse.azimuth_sine[at],
                        diffuse.azimuth_stride, scratch.polarised_orders.data(), out + ray.pairs);
}

/// Adds the diffuse field's light to every pair's radiance. [L3]
template <class V>
inline void diffuse_scattering(const SweepView& grid, const OpticsView& optics, const RayView& ray,
                               const RaySourcesView& diffuse, const Solution<V>& field,
                               RayScratch<V>& scratch, V* out) {
  weigh_sources(grid, optics, diffuse, scratch);
  for (int at = 0; at < diffuse.sources; ++at) add_source_light(grid, ray, diffuse, field, at, scratch, out);
}

/// Adds the light of the ground at the ray's end. [L4]
template <class V>
inline void ground_in_view(const OpticsView& optics, const RayView& ray, const RaySourcesView& diffuse,
                           const SlantDepthToSun<V>& slant_depth, const Solution<V>& field, V* out) {
  V depth{};
  for (int segment = 0; segment < ray.segments; ++segment)
    depth += load<V>(optics.layers.extinction_per_km + ray.segment[segment].layer * kLaneCount<V>) *
             ray.segment[segment].length_km;
  const V reflected = exp_minus(depth) * load<V>(optics.ground_albedo) * kInversePi;
  for (int pair = 0; pair < ray.pairs; ++pair) {
    const InterpolationWeights& suns = diffuse.sun_weights[diffuse.sources - 1][pair];
    V irradiance{};
    for (int t = 0; t < 4; ++t) irradiance += field.ground_irradiance.data()[suns.first + t] * suns.weight[t];
    if (ray.ground_sun_cosine[pair] > 0.0f)
      irradiance += exp_minus(slant_depth(ray.ground_sun[pair])) * ray.ground_sun_cosine[pair];
    out[pair] += reflected * irradiance;
  }
}

/// Where the diffuse light falls by orders of magnitude from one sun node to the next (deep twilight over a
/// low top of the atmosphere, when the earth's shadow covers all of the air), cubic interpolation between the
/// nodes undershoots. Light is never negative: what comes out so is night. [theory.md §5]
template <class V>
inline V without_undershoot(V radiance) {
  return select<V>(radiance < 0.0f, V{}, radiance);
}

}  // namespace skylut::transfer
