#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "skylut/transfer/plane_parallel.hpp"

namespace skylut::plane_parallel {

/// Directions by their zenith angles: many directions share few of them, and what a zenith angle costs is
/// done once for each.
struct ViewList {
  explicit ViewList(std::span<const PlaneDirection> directions);

  std::vector<double> cosines;            ///< the distinct ones, in order of first appearance
  std::vector<std::size_t> of_direction;  ///< index into them
};

}  // namespace skylut::plane_parallel
