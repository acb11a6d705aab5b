#include "sweep_tables.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut::transfer {

SweepTables::SweepTables(const Discretisation& grid) {
  const AngularGrid& angles = grid.angles;
  const SweepStencil& stencil = grid.stencil;
  const int nodes = static_cast<int>(grid.common.sun_nodes_deg.size());
  for (int m = 0; m < angles.azimuthal_orders(); ++m) {
    moment_offset_.push_back(angles.moment_offset(m));
    for (int l = m; l <= angles.resolution().max_l; ++l) moment_degree_.push_back(l);
  }
  moment_offset_.push_back(angles.moments());
  for (int j = 0; j < angles.polar_nodes(); ++j) {
    const auto node = static_cast<std::size_t>(j);
    const double weight =
        angles.polar_weight()[node] * angles.cos_polar()[node] * 2.0 * kPi / angles.azimuth_nodes();
    flux_weight_.insert(flux_weight_.end(), static_cast<std::size_t>(angles.azimuth_nodes()),
                        static_cast<float>(weight));
  }
  for (const double node_deg : grid.common.sun_nodes_deg) {
    const double cosine = std::cos(node_deg * kRadiansPerDegree);
    sun_cosine_.push_back(static_cast<float>(grid.common.slant_depth.cos_apparent_sun(0.0, cosine)));
    for (int m = 0; m < angles.azimuthal_orders(); ++m)
      for (const double value : normalised_legendre(m, angles.resolution().max_l, -cosine))
        beam_moment_.push_back(static_cast<float>(value / (4.0 * kPi)));
  }

  view_.slant_depth = grid.common.slant_depth.view();
  view_.sublayers = grid.sublayers.layers();
  view_.sun_nodes = nodes;
  view_.polar_nodes = angles.polar_nodes();
  view_.azimuth_nodes = angles.azimuth_nodes();
  view_.azimuthal_orders = angles.azimuthal_orders();
  view_.moments = angles.moments();
  view_.legendre_terms = angles.resolution().max_l + 1;
  view_.chord_nodes = stencil.chord_nodes();
  view_.layer_of_sublayer = grid.layer_of_sublayer.data();
  view_.moment_offset = moment_offset_.data();
  view_.moment_degree = moment_degree_.data();
  for (const Hemisphere hemisphere : {kDown, kUp}) {
    for (int m = 0; m < angles.azimuthal_orders(); ++m) {
      polar_synthesis_[hemisphere].push_back(angles.polar_synthesis(hemisphere, m).data());
      polar_analysis_[hemisphere].push_back(angles.polar_analysis(hemisphere, m).data());
    }
    view_.polar_synthesis[hemisphere] = polar_synthesis_[hemisphere].data();
    view_.polar_analysis[hemisphere] = polar_analysis_[hemisphere].data();
    view_.polar_step[hemisphere] = &stencil.polar(hemisphere, 0, 0);
    view_.sun_weights[hemisphere] = stencil.sun(hemisphere, 0, 0);
  }
  for (const int parity : {0, 1}) {
    view_.azimuth_synthesis[parity] = angles.azimuth_synthesis(parity).data();
    view_.azimuth_analysis[parity] = angles.azimuth_analysis(parity).data();
  }
  view_.flux_weight = flux_weight_.data();
  view_.beam_moment = beam_moment_.data();
  view_.sun_cosine = sun_cosine_.data();
  view_.beam_weights = grid.beam.weights().data();
  view_.first_piece = grid.beam.first_piece().data();
  view_.piece_layer = grid.beam.piece_layer().data();
  if (grid.cuts_peak) view_.horizon = horizon_.emplace(angles, grid.horizon).view();
  if (grid.polarised) view_.polarised = grid.polarised->view();
  view_.piece_thickness_km = grid.beam.piece_thickness_km().data();
}

}  // namespace skylut::transfer
