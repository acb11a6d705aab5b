#pragma once

#include "kernel_problem.hpp"
#include "lane_array.hpp"
#include "polarised_sight.hpp"

// What a line of sight works with. As in lanes.hpp, templates only.

namespace skylut::transfer {

/// Whether a pair interpolates from a sun node. (A template as everything here: each build has its own.)
template <class V>
struct NodeUse {
  bool wanted = false;
};

/// Scratch space of a line of sight.
template <class V>
struct RayScratch {
  RayScratch(const SweepView& grid, const RayView& ray, const RaySourcesView& diffuse)
      : far_depth(static_cast<std::size_t>(ray.pairs)),
        degree_weight(static_cast<std::size_t>(diffuse.sources * grid.legendre_terms)),
        peak_weight(static_cast<std::size_t>(diffuse.sources)),
        direction_weight(static_cast<std::size_t>(grid.moments)),
        source_azimuthal_orders(static_cast<std::size_t>(grid.sun_nodes * grid.azimuthal_orders)),
        upper_orders(static_cast<std::size_t>(4 * grid.azimuthal_orders)),
        node_use(static_cast<std::size_t>(grid.sun_nodes)),
        polarised_weight(static_cast<std::size_t>(3 * diffuse.sources * grid.polarised.degrees)),
        polarised_source(grid),
        polarised_orders(stokes_of(diffuse) == 1
                             ? 0
                             : static_cast<std::size_t>(2 * grid.sun_nodes * grid.polarised.orders)),
        upper_polarised_orders(static_cast<std::size_t>(2 * grid.polarised.orders)),
        radiance(static_cast<std::size_t>(stokes_of(diffuse) * ray.pairs)) {}

  /// Stokes parameters that are asked for.
  static int stokes_of(const RaySourcesView& diffuse) { return diffuse.azimuth_sine == nullptr ? 1 : 3; }

  LaneArray<V> far_depth;                // observer to point to sun, at the end of the last lit part [pair]
  LaneArray<V> degree_weight;            // see weigh_sources [source][degree]
  LaneArray<V> peak_weight;              // the same of the forward peak that is cut off [source]
  LaneArray<V> direction_weight;         // the same times Λ_lm(μ), at one source [moment]
  LaneArray<V> source_azimuthal_orders;  // [sun node][m]
  LaneArray<V> upper_orders;             // the same at the upper level, of a few nodes
  LaneArray<NodeUse<V>> node_use;        // at one source [sun node]
  LaneArray<V> polarised_weight;         // as degree_weight [source][degree][beta1, alpha2, alpha3]
  PolarisedSource<V> polarised_source;
  LaneArray<V> polarised_orders;        // [Q, U][sun node][m]
  LaneArray<V> upper_polarised_orders;  // of one node
  LaneArray<V> radiance;                // [Stokes][pair]
};

/// That of several lines.
template <class V>
class RayScratches {
 public:
  RayScratches(const SweepView& grid, int lines, const RayView* rays, const RaySourcesView* diffuse)
      : scratch_(static_cast<std::size_t>(lines)) {
    for (int i = 0; i < lines; ++i) scratch_.data()[i].own = new RayScratch<V>(grid, rays[i], diffuse[i]);
  }
  ~RayScratches() {
    for (std::size_t i = 0; i < scratch_.size(); ++i) delete scratch_.data()[i].own;
  }
  RayScratches(const RayScratches&) = delete;
  RayScratches& operator=(const RayScratches&) = delete;
  RayScratch<V>& operator[](int line) { return *scratch_.data()[line].own; }

 private:
  struct Slot {
    RayScratch<V>* own = nullptr;
  };
  LaneArray<Slot> scratch_;
};

}  // namespace skylut::transfer
