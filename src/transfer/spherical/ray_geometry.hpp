#pragma once

#include <span>
#include <vector>

#include "block_optics.hpp"
#include "discretisation.hpp"
#include "kernel_problem.hpp"
#include "sunlit_ray.hpp"

namespace skylut::transfer {

/// One sun and relative azimuth under which a line of sight is wanted.
struct SunAzimuth {
  double sun_zenith_deg;
  double relative_azimuth_deg;
};

/// Geometry of a line of sight: the segments between the sublayers' boundaries, the direction of the light
/// in the local frame of each segment's ends, and, for every (sun, azimuth) pair, the parts that the sun
/// reaches and the local solar zenith angle. [theory.md §4.6, G9-G13]
class RayGeometry {
 public:
  RayGeometry(const Discretisation& grid, double observer_km, double view_zenith_deg,
              std::span<const SunAzimuth> pairs);

  int segments() const { return static_cast<int>(segment_.size()); }
  int pairs() const { return static_cast<int>(cos_scattering_.size()); }

  /// The kernel's view; it points into this object.
  RayView view(const Discretisation& grid) const;

  /// Exact phase functions of a block at the scattering angles of the pairs: [pair][scatterer][lane].
  std::vector<float> phases(const BlockOptics& optics) const;

 private:
  std::vector<RayPoint> trace(const Discretisation& grid, double observer_km, double cos_view);
  void add_segments(const Discretisation& grid, const std::vector<RayPoint>& points);
  void add_pair_sources(const Discretisation& grid, const std::vector<RayPoint>& points,
                        std::span<const SunAzimuth> pairs);
  void add_lit_parts(const Discretisation& grid, const std::vector<RayPoint>& points,
                     std::span<const SunAzimuth> pairs);

  bool hits_ground_ = false;
  std::vector<RaySegment> segment_;
  std::vector<float> polar_moment_;
  std::vector<RaySource> source_;
  std::vector<float> azimuth_factor_;
  std::vector<LitPart> lit_;
  std::vector<int> first_lit_;
  std::vector<float> level_altitude_km_;
  std::vector<float> ground_perigee_km_;
  std::vector<float> ground_sun_cosine_;
  std::vector<double> cos_scattering_;
};

}  // namespace skylut::transfer
