#pragma once

#include <cstddef>

#include "skylut/models/compact/cubic_spline.hpp"

namespace skylut::compact {

/// The zenith angles at which a compact sky is known: three panels, above the horizontal, from there to the
/// geometric horizon and on to the nadir, each with a coordinate whose whole numbers are its nodes.
///   above   ln(1 + e/1.5°) of the elevation e: crowds the horizon
///   limb    0.4 × depression/dip + 0.6 × (1 - ln(1 + p/1.5 km)/ln(1 + h/1.5 km)), p the line's lowest
///           altitude, h the observer's: even in angle, and crowding the haze near the ground
///   ground  ln(1 + (θ - θ_horizon)/0.5°)
class ZenithGrid {
 public:
  struct Counts {
    std::size_t above = 0;
    std::size_t limb = 0;
    std::size_t ground = 0;
  };

  ZenithGrid() = default;
  /// @param counts  at least 4 each
  ZenithGrid(const Counts& counts, double planet_radius_km);

  std::size_t size() const { return counts_.above + counts_.limb + counts_.ground; }
  const Counts& counts() const { return counts_; }

  /// Zenith angle of a node, of all panels one after another, for an observer.
  double node_zenith_deg(std::size_t node, double altitude_km) const;

  /// What a zenith angle is interpolated from.
  SplineTaps taps(double zenith_deg, double altitude_km) const;

 private:
  double horizon_zenith_deg(double altitude_km) const;
  double limb_coordinate(double zenith_deg, double altitude_km, double horizon_deg) const;

  Counts counts_;
  double planet_radius_km_ = 0.0;
  CubicSpline above_;
  CubicSpline limb_;
  CubicSpline ground_;
};

}  // namespace skylut::compact
