#pragma once

#include "skylut/models/perez.hpp"
#include "skylut/models/sky_model.hpp"

namespace skylut {

/// Perez coefficients of Y, x and y.
struct PerezYxy {
  PerezCoefficients Y;
  PerezCoefficients x;
  PerezCoefficients y;
};

/// A sky of three Perez formulas scaled to a zenith colour: one row of a table, or what a published model
/// gives for one turbidity and sun.
class PerezSky final : public Sky {
 public:
  /// @param zenith              Y in cd/m²
  /// @param horizon_zenith_deg  [90, 180): where the formulas have their horizon. They take a view's zenith
  ///                            angle times 90 over it, and its true angle to the sun.
  PerezSky(const PerezYxy& coefficients, const Yxy& zenith, const Direction& sun,
           double horizon_zenith_deg = 90.0)
      : coefficients_(coefficients), zenith_(zenith), sun_(sun), horizon_zenith_deg_(horizon_zenith_deg) {}

  const PerezYxy& coefficients() const { return coefficients_; }
  const Yxy& zenith() const { return zenith_; }  ///< Y in cd/m²
  const Direction& sun() const { return sun_; }
  double horizon_zenith_deg() const { return horizon_zenith_deg_; }

  using Sky::colour;
  /// @throws InputError  for a view not within 0 to the horizon's zenith angle, or at the horizon where a B
  /// is not below 0 (infinite there)
  void colour(std::span<const Direction> views, std::span<Yxy> colours) const override;

 private:
  PerezYxy coefficients_;
  Yxy zenith_;
  Direction sun_;
  double horizon_zenith_deg_;
};

/// The zenith angle that a Perez formula is given for a view.
/// @param horizon_zenith_deg  as PerezSky's
/// @param largest_B           of the formulas
/// @throws InputError  for a view that they have nothing for: beyond their horizon, or at it where a B is not
/// below 0
double perez_zenith_deg(const Direction& view, double horizon_zenith_deg, double largest_B);

}  // namespace skylut
