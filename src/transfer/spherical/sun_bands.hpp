#pragma once

#include <span>
#include <vector>

#include "skylut/transfer/quality.hpp"

namespace skylut::transfer {

/// Suns that share the nodes of local solar zenith angle among which their diffuse field is interpolated.
///
/// A sky holds light from where the sun stands a few degrees otherwise than at the observer, so that a field
/// for one sun needs the nodes around it only. The bands are fixed: a sky does not depend on which other suns
/// are asked for. [docs/validation.md, "Convergence"]
struct SunBand {
  double last_deg;                ///< the largest sun zenith angle that belongs to it
  std::vector<double> nodes_deg;  ///< ascending
};

/// All bands by zenith angle, ascending; one that holds every node unless the options ask for bands. Then one
/// of deep twilight, and last one for lines of sight that enter the air from outside: they cross it from side
/// to side, 20° of suns on Earth, and need all nodes.
std::vector<SunBand> sun_bands(const DiscretisationOptions& options);

/// The band of a sun. @param sun_zenith_deg  [0, 99]
std::size_t band_of(std::span<const SunBand> bands, double sun_zenith_deg);

}  // namespace skylut::transfer
