#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "lanes.hpp"

namespace skylut::transfer {

/// In a thick cloud an iteration moves light by one free path, and its changes say little of how far it has
/// to go. There light diffuses, and the error of the mean intensity and of the flux obeys a diffusion
/// equation whose source is what the last sweep has left out: the difference between the moments that it
/// has found and those that it took its sources from (diffusion synthetic acceleration; Kopp 1963,
/// doi:10.13182/NSE63-1; Larsen 1982, doi:10.13182/NSE82-1). It is solved level by level under each sun node
/// and added to the moments. Columns that a few iterations solve are left alone. [I5]
template <class V>
class DiffusionCorrection {
 public:
  DiffusionCorrection(const SweepView& grid, const OpticsView& optics);

  /// Lanes that are corrected.
  LaneMask<V> thick() const { return thick_; }

  /// Corrects the moments of both hemispheres [level][node][moment] of one sun node in some lanes.
  /// @return Σ |correction of M_00| over the levels
  V correct(int node, LaneArray<V> (&hemisphere)[2], LaneMask<V> lanes);

 private:
  /// Transport depth, ∫ β_sca (1-g) dz, above which columns are corrected.
  static constexpr float kThick = 2.0f;

  /// What a sublayer does to the diffuse light.
  struct Medium {
    const float* source_factor;  // ω (2l+1) χ_l [l][lane]
    V depth;
    V absorption;  // depth
    V transport;   // depth, absorption + scattering × (1 - asymmetry)
  };
  Medium medium(int sublayer) const;
  LaneMask<V> find_thick() const;
  /// 0 if no lane is corrected.
  std::size_t levels() const {
    return any_lane<V>(thick_) ? static_cast<std::size_t>(grid_.sublayers + 1) : 0;
  }

  const SweepView& grid_;
  const OpticsView& optics_;
  LaneMask<V> thick_;
  LaneArray<V> half_mean_;    // ½∫₀¹ P_l dμ [l]
  LaneArray<V> half_flux_;    // ½∫₀¹ μ P_l dμ [l]
  LaneArray<V> used_;         // M_l0 that the next sweep takes its sources from [level][node][hemisphere][l]
  LaneArray<V> mean_;         // correction of M_00 [level]
  LaneArray<V> flux_;         // of M_10: first what the sources make of it in a sublayer [sublayer]
  LaneArray<V> conductance_;  // [sublayer]
  LaneArray<V> pivot_;        // [level]
};

template <class V>
DiffusionCorrection<V>::DiffusionCorrection(const SweepView& grid, const OpticsView& optics)
    : grid_(grid),
      optics_(optics),
      thick_(find_thick()),
      half_mean_(static_cast<std::size_t>(grid.legendre_terms)),
      half_flux_(static_cast<std::size_t>(grid.legendre_terms)),
      used_(levels() * static_cast<std::size_t>(grid.sun_nodes * 2 * grid.legendre_terms)),
      mean_(levels()),
      flux_(levels()),
      conductance_(levels()),
      pivot_(levels()) {
  // ∫₀¹ P_l = (P_{l-1}(0) - P_{l+1}(0))/(2l+1), and μ P_l = ((l+1) P_{l+1} + l P_{l-1})/(2l+1).
  float before = 0.0f;  // ∫₀¹ P_{l-1}
  float here = 1.0f;
  float at_zero = 1.0f;  // P_{l-1}(0) for odd l
  for (int l = 0; l < grid.legendre_terms; ++l) {
    const auto degree = static_cast<float>(l);
    float next = 0.0f;  // ∫₀¹ P_{l+1}
    if (l % 2 == 0) {
      const float later = -at_zero * (degree + 1.0f) / (degree + 2.0f);  // P_{l+2}(0)
      next = (at_zero - later) / (2.0f * degree + 3.0f);
      at_zero = later;
    }
    half_mean_.data()[l] = broadcast<V>(0.5f * here);
    half_flux_.data()[l] =
        broadcast<V>(0.5f * ((degree + 1.0f) * next + degree * before) / (2.0f * degree + 1.0f));
    before = here;
    here = next;
  }
}

template <class V>
LaneMask<V> DiffusionCorrection<V>::find_thick() const {
  V depth{};
  for (int k = 0; k < grid_.sublayers; ++k) {
    const Medium here = medium(k);
    depth += here.transport - here.absorption;
  }
  return depth > kThick;
}

template <class V>
typename DiffusionCorrection<V>::Medium DiffusionCorrection<V>::medium(int sublayer) const {
  const int layer = grid_.layer_of_sublayer[sublayer];
  float thickness_km = 0.0f;
  for (int piece = grid_.first_piece[sublayer]; piece < grid_.first_piece[sublayer + 1]; ++piece)
    thickness_km += grid_.piece_thickness_km[piece];
  const V depth = load<V>(optics_.sweep_layers.extinction_per_km + layer * kLaneCount<V>) * thickness_km;
  const float* factor = optics_.sweep_layers.source_factor + layer * grid_.legendre_terms * kLaneCount<V>;
  const V forward = load<V>(factor + kLaneCount<V>) * (1.0f / 3.0f);
  return {factor, depth, lane_max(depth * (1.0f - load<V>(factor)), V{}), depth * (1.0f - forward)};
}

/// With I = a + 3bμ for the error, a and b the corrections of M_00 and M_10, q₀ and q₁ the moments of what
/// the sweep left out, per optical depth upwards
///   b' + (1-ω) a = q₀,  a'/3 + (1-ωg) b = q₁,
/// nothing from above (b = a/2 at the top, Marshak's condition), albedo A at the ground, b = -a (1-A)/2(1+A).
/// Downward directions were swept with the upward moments of before and, at half of a sublayer's ends, the
/// downward ones; upward directions with the upward ones at half of the ends.
template <class V>
V DiffusionCorrection<V>::correct(int node, LaneArray<V> (&hemisphere)[2], LaneMask<V> lanes) {
  const int levels = grid_.sublayers + 1;
  V* const mean = mean_.data();
  V* const flux = flux_.data();
  V* const conductance = conductance_.data();
  V* const pivot = pivot_.data();
  const auto moments = [&](Hemisphere each, int level) {
    return hemisphere[each].data() +
           static_cast<std::size_t>(level * grid_.sun_nodes + node) * static_cast<std::size_t>(grid_.moments);
  };
  const int terms = grid_.legendre_terms;
  const auto used = [&](Hemisphere each, int level) {
    return used_.data() +
           static_cast<std::size_t>(((level * grid_.sun_nodes + node) * 2 + (each == kUp ? 1 : 0)) * terms);
  };
  for (int level = 0; level < levels; ++level) {
    mean[level] = V{};
    pivot[level] = V{};
  }
  for (int k = 0; k < grid_.sublayers; ++k) {
    const Medium here = medium(k);
    // A floor that keeps the equations solvable in single precision where there is hardly any air.
    const V inverse = 1.0f / lane_max(here.transport, broadcast<V>(1e-3f));
    V across{};
    for (int level = k; level <= k + 1; ++level) {
      const V* down = moments(kDown, level);
      const V* up = moments(kUp, level);
      const V* down_used = used(kDown, level);
      const V* up_used = used(kUp, level);
      V left{};
      for (int l = 0; l < terms; ++l) {
        const V for_up = 0.5f * (up[l] - up_used[l]);
        V for_down = 0.5f * (down[l] - down_used[l]) + 2.0f * for_up;
        if (l % 2 == 1) for_down = -for_down;
        const V factor = load<V>(here.source_factor + l * kLaneCount<V>);
        left += factor * half_mean_.data()[l] * (for_down + for_up);
        across += factor * half_flux_.data()[l] * (for_up - for_down);
      }
      mean[level] += 0.5f * here.depth * left;
      pivot[level] += 0.5f * here.absorption;
    }
    across *= 0.5f * here.depth;
    conductance[k] = (1.0f / 3.0f) * inverse;
    flux[k] = across * inverse;
    mean[k] -= flux[k];
    mean[k + 1] += flux[k];
    pivot[k] += conductance[k];
    pivot[k + 1] += conductance[k];
  }
  const V albedo = load<V>(optics_.ground_albedo);
  pivot[0] += 0.5f * (1.0f - albedo) / (1.0f + albedo);
  pivot[levels - 1] += 0.5f;
  for (int level = 1; level < levels; ++level) {
    const V share = conductance[level - 1] / pivot[level - 1];
    pivot[level] -= share * conductance[level - 1];
    mean[level] += share * mean[level - 1];
  }
  mean[levels - 1] /= pivot[levels - 1];
  for (int level = levels - 2; level >= 0; --level)
    mean[level] = (mean[level] + conductance[level] * mean[level + 1]) / pivot[level];
  for (int k = 0; k < grid_.sublayers; ++k) flux[k] -= conductance[k] * (mean[k + 1] - mean[k]);

  V sum{};
  for (int level = 0; level < levels; ++level) {
    const V below = flux[level > 0 ? level - 1 : 0];
    const V above = flux[level + 1 < levels ? level : level - 1];
    const V a = select<V>(lanes, mean[level], V{});
    const V b = select<V>(lanes, 1.5f * (below + above), V{});
    sum += lane_max(a, -a);
    V* down = moments(kDown, level);
    V* up = moments(kUp, level);
    // Moments of a + bμ over either hemisphere.
    for (int l = 0; l < terms; ++l) {
      const V even = half_mean_.data()[l] * a;
      const V odd = half_flux_.data()[l] * b;
      up[l] += even + odd;
      down[l] += l % 2 == 0 ? even - odd : odd - even;
      used(kUp, level)[l] = up[l];
      used(kDown, level)[l] = down[l];
    }
  }
  return sum;
}

}  // namespace skylut::transfer
