#pragma once

#include <memory>
#include <vector>

#include "haze_terms.hpp"
#include "skylut/models/compact/tables.hpp"
#include "training_spectrum.hpp"

namespace skylut::compact {

/// Features of all conditions of a training: [load][altitude][sun][zenith node][number of the layout].
struct TrainingFields {
  Nodes nodes;
  ZenithGrid zenith;
  double planet_radius_km = 0.0;
  std::vector<float> features;
  std::unique_ptr<const HazeTerms> haze;
  std::vector<double> rayleigh_0;       ///< [channel]
  std::vector<double> rayleigh_90;      ///< [channel]
  std::vector<float> spherical_albedo;  ///< [2][load][channel], see Tables
};

/// Solves all loads at once, over a black and a white ground, and follows every line of sight once for all of
/// them and all suns: what belongs to the line alone is most of its cost.
/// @param zenith_counts  at least 4 each
/// @param haze_terms     u_k
TrainingFields training_fields(const Context& context, const SkyScene& scene,
                               const TrainingSpectrum& spectrum, const Nodes& nodes,
                               const ZenithGrid::Counts& zenith_counts, std::size_t haze_terms,
                               const TransferOptions& options);

}  // namespace skylut::compact
