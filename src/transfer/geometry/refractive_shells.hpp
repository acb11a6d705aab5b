#pragma once

#include <vector>

#include "shell_geometry.hpp"
#include "skylut/scattering/optical_column.hpp"

namespace skylut::transfer {

/// Shells whose refractive index n bends light by Bouguer's rule, n r sin ψ = b all along a ray, ψ being its
/// local zenith angle. With the optical radius x = n r that is the law of a STRAIGHT line among shells of
/// radius x: at w = √(x² - b²) from its lowest point, cos ψ = w/x. So rays are found in these optical shells,
/// as straight ones are, and then
///   path       ds = (dr/dx) dw,
///   turned     dφ = (x/r)(dr/dx) d atan2(w, b)   (the angle at the planet's centre),
///   bending    dε = -(d ln n/dx) b dw/x.
/// Between levels x is linear in r for path and turning; for the bending, whose derivative the beam's
/// defocusing asks for, ln n is a cubic in x whose slope has no jumps. [docs/refraction.md §2]
///
/// Lengths in km; "optical altitude" is x - x(ground).
class RefractiveShells {
 public:
  /// @param shells  with a refractivity at every level
  /// @throws InputError  for refractivities that are negative or not as many as the levels, and for air that
  ///                     bends light more than the ground curves: it traps rays
  explicit RefractiveShells(const Shells& shells);

  const ShellGeometry& layers() const { return layers_; }
  /// The levels at their optical altitudes, over a planet of the ground's optical radius.
  const ShellGeometry& optical() const { return optical_; }
  /// The same for other levels.
  ShellGeometry optical(const ShellGeometry& levels) const;

  double optical_km(double altitude_km) const;
  double altitude_km(double optical_km) const;
  /// dr/dx in a layer.
  double stretch(int layer) const { return stretch_[static_cast<std::size_t>(layer)]; }
  const std::vector<double>& stretch() const { return stretch_; }

  /// By how much a ray that leaves a point upwards is bent until it is outside, rad.
  /// @param along_km  x cos ψ of the ray at the point, >= 0
  double bending_above(double optical_km, double along_km) const;

  /// The same within one layer.
  /// @param impact_km         b
  /// @param from_km, to_km    w at its ends, 0 <= from_km <= to_km
  double bending_within(int layer, double impact_km, double from_km, double to_km) const;

 private:
  /// -d ln n/dx in a layer: Σ rate[i] t^i, t from 0 at its bottom to 1.
  struct BendingRate {
    double rate[3];
  };

  ShellGeometry layers_;
  ShellGeometry optical_;
  std::vector<double> stretch_;
  std::vector<BendingRate> rate_;
};

}  // namespace skylut::transfer
