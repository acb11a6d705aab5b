#pragma once

#include <span>
#include <vector>

#include "interpolation.hpp"
#include "local_sun.hpp"
#include "ray_trace.hpp"
#include "ray_view.hpp"
#include "shell_geometry.hpp"
#include "slant_depth_grid.hpp"

namespace skylut::transfer {

/// What rays run through, and how finely they are cut.
struct RaySpace {
  const ShellGeometry& layers;
  const SlantDepthGrid& slant_depth;
  const CubicInterpolation& sun_interpolation;  ///< among the sun nodes of the diffuse field
  double ray_step_km;                           ///< as in DiscretisationOptions
  double sunbeam_step_km;
  const RefractiveShells* refractive = nullptr;  ///< that bend the lines; null: they are straight

  /// A line of sight that stops at these levels; bent ones need all of the layers' among them.
  RayTrace trace(const ShellGeometry& levels, double observer_km, double cos_view) const;
};

/// A line of sight, for all suns and azimuths under which it is wanted: the layers it crosses and its length
/// in each, the parts that each sun reaches, where the suns stand in the local frame of its points, and its
/// end. All that single scattering, the diffuse field's source and the ground ask of it, the same for all
/// columns. Straight, or bent by refraction. [theory.md §4.6, G9-G13; docs/refraction.md §4]
class Ray {
 public:
  /// @param azimuthal_orders  that the local suns are wanted in, at least 2
  Ray(const RaySpace& space, double observer_km, double view_zenith_deg, std::span<const SunAzimuth> pairs,
      int azimuthal_orders);

  int segments() const { return static_cast<int>(segment_.size()); }
  int pairs() const { return static_cast<int>(cos_scattering_.size()); }
  double observer_km() const { return start_.altitude_km; }
  double cos_view() const { return start_.cos_view; }
  bool hits_ground() const { return hits_ground_; }

  /// Cosine of the scattering angle, which is constant along a straight ray; along a bent one taken as the
  /// angle between view and sun as they appear to the observer. [pair]
  const std::vector<double>& cos_scattering() const { return cos_scattering_; }
  /// Place of a pair among those in the aureole, where forward peaks are felt; -1: too far from the sun.
  /// [pair]
  const std::vector<int>& aureole() const { return aureole_; }

  /// Where the suns stand seen from a point of it.
  const LocalSun::Point& suns_at(const RayPoint& point) { return local_sun_.at(point); }
  int azimuthal_orders() const { return local_sun_.azimuthal_orders(); }

  /// The kernel's view; it points into this object.
  RayView view() const;

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
  LocalSun local_sun_;
};

/// The aureole, in which the spread of forward peaks is felt: 1 within 15° of the sun, 0 beyond 20°, linear
/// in the cosine between, so that no edge shows where the correction ends.
double aureole_weight(double cos_scattering_angle);

}  // namespace skylut::transfer
