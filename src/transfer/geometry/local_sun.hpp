#pragma once

#include <map>
#include <span>
#include <vector>

#include "interpolation.hpp"
#include "ray_trace.hpp"

namespace skylut::transfer {

/// One sun and relative azimuth under which a line of sight is wanted.
struct SunAzimuth {
  double sun_zenith_deg;
  double relative_azimuth_deg;
};

/// Solar zenith angle and azimuth of the light in the local frame of points along one line of sight, for all
/// its pairs. The discretisations that share the ray share most of their points: each is worked out once.
/// [theory.md §4.6, G10-G11]
class LocalSun {
 public:
  /// @param bends   points of a bent line: their turned_rad counts instead of their distance
  /// @param suns    interpolation among the sun nodes, by zenith angle in degrees; must outlive this object
  /// @param azimuthal_orders  wanted, at least 2
  LocalSun(double planet_radius_km, const RayPoint& start, bool bends, std::span<const SunAzimuth> pairs,
           const CubicInterpolation& suns, int azimuthal_orders);

  struct Point {
    std::vector<InterpolationWeights> sun_weights;  ///< [pair]
    std::vector<float> azimuth_factor;              ///< [pair][m]: (2-δ_m0) cos mφ
    std::vector<float> azimuth_sine;                ///< [pair][m]: 2 sin mφ
  };
  /// References stay valid.
  const Point& at(const RayPoint& point);

  int azimuthal_orders() const { return azimuthal_orders_; }

 private:
  struct AtStart {
    double along_sun_km;
    double cos_scattering;
    double cos_azimuth;
    double cos_sun;
    double sun_towards_view;  // sin of the sun's zenith angle, times cos_azimuth
  };
  Point locate(const RayPoint& point) const;
  /// Of the sun's direction with the point's vertical and with the local direction of view.
  struct Cosines {
    double sun;
    double scattering;
  };
  Cosines cosines_at(const RayPoint& point, const AtStart& pair) const;

  double planet_km_;
  bool bends_;
  const CubicInterpolation* suns_;
  int azimuthal_orders_;
  std::vector<AtStart> pairs_;
  std::map<double, Point> known_;  // by distance from the observer
};

}  // namespace skylut::transfer
