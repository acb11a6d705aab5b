#pragma once

#include "diffuse_field.hpp"
#include "line_of_sight.hpp"

// A block of lanes from its optics to a solved diffuse field (solve_block, at the end), which then answers
// lines of sight. As in lanes.hpp, templates only.

namespace skylut::transfer {

template <class V>
class SolvedLanes final : public SolvedBlock {
 public:
  template <class Field>
  SolvedLanes(const SweepView& grid, const OpticsView& optics, SlantDepthToSun<V>&& slant_depth, Field& field)
      : optics_(optics),
        slant_depth_(static_cast<SlantDepthToSun<V>&&>(slant_depth)),
        slant_peak_depth_(grid.slant_depth, optics.peak_per_km, false),
        solution_{grid, field.take_moments(), field.take_polarised_moments(), field.take_ground_irradiance(),
                  HorizonDeficit<V>(grid, optics, field.horizon_light())} {}

  /// Radiance of the ray for every pair: L1 + L3 + L4.
  void line_of_sight(const RayView& ray, const RaySourcesView& diffuse, const float* phase,
                     const float* peaks, const PolarisedScattering* polarised,
                     float* radiance) const override {
    const SweepView& grid = solution_.grid;
    RayScratch<V> scratch(grid, ray, diffuse);
    V* out = scratch.radiance.data();
    single_scattering(grid, optics_, ray, phase, peaks, slant_depth_, slant_peak_depth_, scratch, out);
    if (polarised != nullptr) single_polarised_scattering(ray, *polarised, scratch, out + ray.pairs);
    diffuse_scattering(grid, optics_, ray, diffuse, solution_, scratch, out);
    if (ray.hits_ground) ground_in_view(optics_, ray, diffuse, slant_depth_, solution_, out);
    for (int pair = 0; pair < ray.pairs; ++pair)
      store(without_undershoot(out[pair]), radiance + pair * kLaneCount<V>);
    if (polarised == nullptr) return;
    for (int i = ray.pairs; i < 3 * ray.pairs; ++i) store(out[i], radiance + i * kLaneCount<V>);
  }

  /// The same in parts, of several lines: the amplitudes of L1 and L5, then L3 + L4. The field is larger than
  /// a processor's caches; so the lines take its light level by level, all of them together.
  void parts_of_sights(int lines, const RayView* rays, const RaySourcesView* diffuse,
                       float* const* parts) const override {
    const SweepView& grid = solution_.grid;
    RayScratches<V> scratch(grid, lines, rays, diffuse);
    for (int i = 0; i < lines; ++i) weigh_sources(grid, optics_, diffuse[i], scratch[i]);
    for (int sublayer = 0; sublayer < grid.sublayers; ++sublayer)
      for (int i = 0; i < lines; ++i)
        for (int at = 0; at < diffuse[i].sources; ++at)
          if (diffuse[i].source[at].sublayer == sublayer)
            add_source_light(grid, rays[i], diffuse[i], solution_, at, scratch[i],
                             scratch[i].radiance.data());
    for (int i = 0; i < lines; ++i) finish_parts(rays[i], diffuse[i], scratch[i], parts[i]);
  }

 private:
  /// Q and U of singly scattered light: F12 in the place of F11, turned into the vertical plane. [P9]
  void single_polarised_scattering(const RayView& ray, const PolarisedScattering& polarised,
                                   RayScratch<V>& scratch, V* q) const {
    LaneArray<V> scattered(static_cast<std::size_t>(ray.pairs));
    single_scattering(solution_.grid, optics_, ray, polarised.f12, nullptr, slant_depth_, slant_peak_depth_,
                      scratch, scattered.data());
    for (int pair = 0; pair < ray.pairs; ++pair) {
      q[pair] += scattered.data()[pair] * polarised.rotation[2 * pair];
      q[ray.pairs + pair] += scattered.data()[pair] * polarised.rotation[2 * pair + 1];
    }
  }

  void finish_parts(const RayView& ray, const RaySourcesView& diffuse, RayScratch<V>& scratch,
                    float* parts) const {
    const std::size_t amplitudes = static_cast<std::size_t>(3 * optics_.scatterers * ray.pairs);
    LaneArray<V> amplitude(amplitudes);
    single_scattering_amplitudes(solution_.grid, optics_, ray, slant_depth_, slant_peak_depth_, scratch,
                                 amplitude.data());
    V* out = scratch.radiance.data();
    if (ray.hits_ground) ground_in_view(optics_, ray, diffuse, slant_depth_, solution_, out);
    for (std::size_t i = 0; i < amplitudes; ++i) store(amplitude.data()[i], parts + i * kLaneCount<V>);
    for (std::size_t i = 0; i < scratch.radiance.size(); ++i)
      store(out[i], parts + (amplitudes + i) * kLaneCount<V>);
  }

  OpticsView optics_;
  SlantDepthToSun<V> slant_depth_;
  SlantDepthToSun<V> slant_peak_depth_;  // of the forward peak that delta-M cuts off
  Solution<V> solution_;
};

template <class V, int kStokes, class Sizes>
inline SolvedBlock* solve_block(const SweepView& grid, const Sizes& sizes, const OpticsView& optics,
                                const IterationLimits& limits, IterationReport& report) {
  SlantDepthToSun<V> slant_depth(grid.slant_depth, optics.layers.extinction_per_km);
  DiffuseField<V, Sizes, kStokes> field(grid, sizes, optics, slant_depth);
  report = field.solve(limits);
  if (report.end != IterationReport::kConverged) return nullptr;
  return new SolvedLanes<V>(grid, optics, static_cast<SlantDepthToSun<V>&&>(slant_depth), field);
}

template <class V>
inline SolvedBlock* solve_block(const SweepView& grid, const OpticsView& optics,
                                const IterationLimits& limits, IterationReport& report) {
  return with_sizes<V>(grid.polar_nodes, grid.azimuth_nodes, grid.azimuthal_orders, grid.legendre_terms,
                       [&](const auto& sizes) {
                         return grid.polarised.moments > 0
                                    ? solve_block<V, 3>(grid, sizes, optics, limits, report)
                                    : solve_block<V, 1>(grid, sizes, optics, limits, report);
                       });
}

}  // namespace skylut::transfer
