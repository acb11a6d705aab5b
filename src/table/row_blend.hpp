#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "skylut/models/perez_sky.hpp"
#include "skylut/table/table_entry.hpp"

namespace skylut {

/// One row of a table and how much it counts.
struct WeightedRow {
  const TableEntry* entry = nullptr;
  double weight = 0.0;
};

/// The sky between rows: for Y, x and y each
///   ln v(θ, γ) = Σ w_i ln v_i(θ, γ),   v_i(θ, γ) = v_z,i F_i(θ, γ)/F_i(0, θ_s,i)     [fit.md T1]
/// with θ stretched to the horizon of the observer asked for, as the rows' are to theirs, and with γ the
/// angle to the sun that is asked for, not to the row's: the aureole stands where the sun does. γ is held
/// within what the row's own dome has of it. Where a v_i is not positive, Σ w_i v_i instead.
class RowBlend final : public Sky {
 public:
  /// @param rows                one or more, their weights 1 together
  /// @param horizon_zenith_deg  as PerezSky's
  RowBlend(const std::vector<WeightedRow>& rows, const Direction& sun, double horizon_zenith_deg);

  using Sky::colour;
  /// @throws InputError  as PerezSky::colour
  void colour(std::span<const Direction> views, std::span<Yxy> colours) const override;

 private:
  struct Term {
    PerezYxy coefficients;
    Yxy scale;  // v_z/F(0, θ_s)
    double weight = 0.0;
    double lowest_gamma_rad = 0.0;
    double highest_gamma_rad = 0.0;

    /// @param cosines  of the view's zenith angle and of gamma
    Yxy colour(double cos_zenith, double gamma_rad, double cos_gamma) const;
  };

  std::vector<Term> terms_;
  Direction sun_;
  double horizon_zenith_deg_;
  double largest_B_ = 0.0;
};

/// A weighted sum of skies, Y, x and y each; weights may be negative.
class LayerSum final : public Sky {
 public:
  explicit LayerSum(std::vector<std::pair<std::unique_ptr<const Sky>, double>> skies)
      : skies_(std::move(skies)) {}

  using Sky::colour;
  void colour(std::span<const Direction> views, std::span<Yxy> colours) const override;

 private:
  std::vector<std::pair<std::unique_ptr<const Sky>, double>> skies_;
};

}  // namespace skylut
