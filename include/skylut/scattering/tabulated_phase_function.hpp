#pragma once

#include <memory>
#include <vector>

#include "skylut/scattering/phase_function.hpp"

namespace skylut {

/// Moments of a scattering matrix beside those of its phase function (scattering_matrix.hpp), l = 0 …
struct PolarisationMoments {
  std::vector<double> alpha2;
  std::vector<double> alpha3;
  std::vector<double> beta1;
};

/// A phase function given by its Legendre moments and tabulated by angle, fine towards forward: value() is
/// a look-up, within 1e-3 of the series for mixtures of sizes (tests/unit/scattering). [docs/aerosols.md P7]
/// With the moments of its polarisation, the matrix of spheres (F22 = F11), F12 and F33 tabulated alike.
class TabulatedPhaseFunction final : public PhaseFunction {
 public:
  /// @param moments  χ_0 = 1, χ_1, …
  explicit TabulatedPhaseFunction(std::vector<double> moments);

  /// @param polarisation  as many of each as moments
  TabulatedPhaseFunction(std::vector<double> moments, PolarisationMoments polarisation);

  /// (1 - part) first + part second.
  TabulatedPhaseFunction(const TabulatedPhaseFunction& first, const TabulatedPhaseFunction& second,
                         double part);

  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;
  ScatteringMatrix matrix(double cos_scattering_angle) const override;
  std::vector<MatrixMoments> matrix_moments(int max_l) const override;
  const std::vector<double>& moments() const { return moments_; }

 private:
  std::vector<double> moments_;
  std::vector<double> table_;  // at equal steps of the grid's coordinate
  PolarisationMoments polarisation_;
  std::vector<double> f12_;  // as table_; empty where nothing is known of polarisation
  std::vector<double> f33_;
};

}  // namespace skylut
