#pragma once

#include <vector>

#include "skylut/scattering/phase_function.hpp"

namespace skylut {

/// The elements of a scattering matrix by angle, as a user gives them.
struct ScatteringTable {
  std::vector<double> theta_deg;  ///< scattering angles, ascending, the first 0, the last 180; at least 4
  std::vector<double> f11;        ///< phase function, > 0
  std::vector<double> f12;        ///< |f12| <= f11
  std::vector<double> f22;        ///< |f22| <= f11
  std::vector<double> f33;        ///< |f33| <= f11
};

/// A scattering matrix given by a table. Between the angles, Lagrange's cubic through the four nearest for
/// ln F11 and for the others' ratios to it; moments of that curve by Gauss-Legendre rules between the angles
/// that are exact to 1e-9 (degrees to 2000, 0 beyond).
class TabulatedScatteringMatrix final : public PhaseFunction {
 public:
  /// @throws InputError  naming the element, its angle, its value and what would be right; where ½∫ F11 dμ
  ///                     differs from 1 by more than 1 % (it is then made 1)
  explicit TabulatedScatteringMatrix(ScatteringTable table);

  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;
  ScatteringMatrix matrix(double cos_scattering_angle) const override;
  std::vector<MatrixMoments> matrix_moments(int max_l) const override;

 private:
  ScatteringMatrix at_angle(double theta_rad) const;

  std::vector<double> theta_rad_;
  std::vector<double> ln_f11_;
  std::vector<double> f12_;  // relative to f11, as f22_ and f33_
  std::vector<double> f22_;
  std::vector<double> f33_;
  std::vector<MatrixMoments> moments_;
};

}  // namespace skylut
