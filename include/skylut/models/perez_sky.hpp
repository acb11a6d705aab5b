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
  /// @param zenith  Y in cd/m²
  PerezSky(const PerezYxy& coefficients, const Yxy& zenith, const Direction& sun)
      : coefficients_(coefficients), zenith_(zenith), sun_(sun) {}

  const PerezYxy& coefficients() const { return coefficients_; }
  const Yxy& zenith() const { return zenith_; }  ///< Y in cd/m²
  const Direction& sun() const { return sun_; }

  using Sky::colour;
  /// @throws InputError  for a view not within 0-90°, or at the horizon where a B is not below 0 (infinite
  /// there)
  void colour(std::span<const Direction> views, std::span<Yxy> colours) const override;

 private:
  PerezYxy coefficients_;
  Yxy zenith_;
  Direction sun_;
};

/// @param largest_B  of the formulas
/// @throws InputError  for a view that a Perez sky has nothing for: not within 0-90°, or at the horizon where
/// a B is not below 0
void require_in_perez_dome(const Direction& view, double largest_B);

}  // namespace skylut
