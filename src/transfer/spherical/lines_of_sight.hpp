#pragma once

#include <span>
#include <vector>

#include "../geometry/local_sun.hpp"
#include "skylut/transfer/sky_radiance.hpp"
#include "sun_bands.hpp"

namespace skylut::transfer {

/// All sights that share observer, zenith angle of view and band of suns share a path, and are solved
/// together.
struct LineOfSight {
  double observer_km = 0.0;
  double view_zenith_deg = 0.0;
  std::vector<SunAzimuth> pairs;    ///< suns and azimuths under which it is wanted
  std::vector<std::size_t> sights;  ///< [pair]: index into the request
};

/// The lines of sight of every band. Those of observers above the air begin where they enter it; what misses
/// the air has none, and is black.
std::vector<std::vector<LineOfSight>> lines_of_sight(const Shells& shells, std::span<const SunBand> bands,
                                                     std::span<const Sight> sights);

}  // namespace skylut::transfer
