#pragma once

#include <vector>

#include "skylut/scattering/phase_function.hpp"

namespace skylut {

/// A scattering matrix given by its moments (scattering_matrix.hpp), 0 beyond the last; exact, and as slow as
/// the series.
class LegendreScatteringMatrix final : public PhaseFunction {
 public:
  /// @param moments  l = 0 …; alpha1 of l = 0 is 1; all within -1 to 1; what l < 2 has of the
  ///                 others is not used
  /// @throws InputError  naming the moment and its degree
  explicit LegendreScatteringMatrix(std::vector<MatrixMoments> moments);

  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;
  ScatteringMatrix matrix(double cos_scattering_angle) const override;
  std::vector<MatrixMoments> matrix_moments(int max_l) const override;

 private:
  std::vector<MatrixMoments> moments_;
};

}  // namespace skylut
