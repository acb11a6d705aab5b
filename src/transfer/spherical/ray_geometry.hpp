#pragma once

#include <span>
#include <vector>

#include "block_optics.hpp"
#include "common_grid.hpp"
#include "kernel_problem.hpp"
#include "local_sun.hpp"
#include "ray_trace.hpp"

namespace skylut::transfer {

/// A line of sight through the medium's layers and, for every (sun, azimuth) pair, the parts that the sun
/// reaches: all that single scattering asks for, the same for all columns. [theory.md §4.6, G9-G13]
class RayGeometry {
 public:
  RayGeometry(const CommonGrid& common, double observer_km, double view_zenith_deg,
              std::span<const SunAzimuth> pairs);

  int segments() const { return static_cast<int>(segment_.size()); }
  int pairs() const { return static_cast<int>(cos_scattering_.size()); }
  const RayPoint& start() const { return start_; }

  /// The kernel's view; it points into this object.
  RayView view() const;

  /// Exact phase functions of a block at the scattering angles of the pairs: [pair][scatterer][lane].
  std::vector<float> phases(const BlockOptics& optics) const;
  /// What spreads the phase functions' peaks, for the pairs close to the sun: [aureole][first,
  /// second][scatterer][lane].
  std::vector<float> peaks(const BlockOptics& optics) const;

 private:
  RayPoint start_{};
  bool hits_ground_ = false;
  std::vector<RaySegment> segment_;
  std::vector<LitPart> lit_;
  std::vector<int> first_lit_;
  std::vector<SlantDepthWeights> lit_end_;
  std::vector<SlantDepthWeights> ground_sun_;
  std::vector<float> ground_sun_cosine_;
  std::vector<double> cos_scattering_;
  std::vector<int> aureole_;
};

}  // namespace skylut::transfer
