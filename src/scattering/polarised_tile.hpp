#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace skylut {

/// The generalised spherical functions of scattering matrices, d^l_02, d^l_22 and d^l_2,-2
/// (core/generalised_legendre.hpp), at a tile of angles together, because a recurrence by itself waits for
/// its own results. One degree at a time, from l = 2.
class PolarisedTile {
 public:
  static constexpr std::size_t kSize = 16;
  using Tile = std::array<double, kSize>;

  explicit PolarisedTile(const Tile& mu) : mu_(mu) {
    for (std::size_t i = 0; i < kSize; ++i) {
      polarising[i] = 0.25 * std::sqrt(6.0) * (1.0 - mu[i]) * (1.0 + mu[i]);
      same[i] = 0.25 * (1.0 + mu[i]) * (1.0 + mu[i]);
      opposite[i] = 0.25 * (1.0 - mu[i]) * (1.0 - mu[i]);
    }
  }

  Tile polarising;  ///< d^l_02
  Tile same;        ///< d^l_22
  Tile opposite;    ///< d^l_2,-2

  /// From degree l to l + 1.
  void advance(std::size_t l) {
    const auto n = static_cast<double>(l);
    const double here = std::sqrt(n * n - 4.0);
    const double there = std::sqrt((n + 1.0) * (n + 1.0) - 4.0);
    // √(l²-m²) √(l²-n²): for d_02 l √(l²-4), for d_2,±2 l²-4.
    const double slope_02 = (2.0 * n + 1.0) / there;
    const double drop_02 = here / there;
    const double scale_22 = 1.0 / (n * there * there);
    const double slope_22 = (2.0 * n + 1.0) * n * (n + 1.0) * scale_22;
    const double shift_22 = 4.0 * (2.0 * n + 1.0) * scale_22;
    const double drop_22 = (n + 1.0) * here * here * scale_22;
    for (std::size_t i = 0; i < kSize; ++i) {
      const double next_polarising = slope_02 * mu_[i] * polarising[i] - drop_02 * polarising_before_[i];
      const double next_same = (slope_22 * mu_[i] - shift_22) * same[i] - drop_22 * same_before_[i];
      const double next_opposite =
          (slope_22 * mu_[i] + shift_22) * opposite[i] - drop_22 * opposite_before_[i];
      polarising_before_[i] = polarising[i];
      same_before_[i] = same[i];
      opposite_before_[i] = opposite[i];
      polarising[i] = next_polarising;
      same[i] = next_same;
      opposite[i] = next_opposite;
    }
  }

 private:
  Tile mu_;
  Tile polarising_before_{};
  Tile same_before_{};
  Tile opposite_before_{};
};

}  // namespace skylut
