#pragma once

#include <memory>
#include <vector>

#include "skylut/scattering/phase_function.hpp"

namespace skylut {

/// A phase function given by its Legendre moments and tabulated by angle, fine towards forward: value() is
/// a look-up, within 1e-3 of the series for mixtures of sizes (tests/unit/scattering). [docs/aerosols.md P7]
class TabulatedPhaseFunction final : public PhaseFunction {
 public:
  /// @param moments  χ_0 = 1, χ_1, …
  explicit TabulatedPhaseFunction(std::vector<double> moments);

  /// (1 - part) first + part second.
  TabulatedPhaseFunction(const TabulatedPhaseFunction& first, const TabulatedPhaseFunction& second,
                         double part);

  double value(double cos_scattering_angle) const override;
  double moment(int l) const override;
  const std::vector<double>& moments() const { return moments_; }

 private:
  std::vector<double> moments_;
  std::vector<double> table_;  // at equal steps of the grid's coordinate
};

}  // namespace skylut
