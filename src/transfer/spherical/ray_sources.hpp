#pragma once

#include <vector>

#include "../geometry/ray.hpp"
#include "discretisation.hpp"
#include "kernel_problem.hpp"

namespace skylut::transfer {

/// Where and how a line of sight asks the diffuse field of one discretisation: source points, with the
/// direction of the light and, for every (sun, azimuth) pair, the local solar zenith angle and azimuth there;
/// between them the pieces within one layer of the medium. [theory.md §4.6, G9-G11, L3]
class RaySources {
 public:
  /// @param ray     with enough azimuthal orders; must outlive this object
  /// @param stokes  whether Q and U are asked for
  RaySources(const Discretisation& grid, Ray& ray, bool stokes);

  /// The kernel's view; it points into this object.
  RaySourcesView view() const;

 private:
  void add_pieces(const Discretisation& grid, const std::vector<RayPoint>& points);

  int azimuth_stride_;
  std::vector<SourcePiece> piece_;
  std::vector<SourcePoint> source_;
  std::vector<RayPoint> source_at_;
  std::vector<float> polar_moment_;
  std::vector<HorizonWeights> horizon_;
  std::vector<const InterpolationWeights*> sun_weights_;
  std::vector<const float*> azimuth_factor_;
  std::vector<const float*> azimuth_sine_;  // empty: Q and U are not asked for
  std::vector<float> rotation_r_;
  std::vector<float> rotation_t_;
};

}  // namespace skylut::transfer
