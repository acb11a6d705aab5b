#pragma once

#include "shell_walk.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/scattering/phase_function.hpp"

namespace skylut::monte_carlo {

/// What a photon carries where light is a number: its weight, and the radiance that it has found.
class IntensityPath {
 public:
  using Law = double;
  using Found = double;

  static Law law(const PhaseFunction& phase, double cos_angle) { return phase.value(cos_angle); }
  static void add(Law& sum, double share, Law law) { sum += share * law; }

  explicit IntensityPath(const Vector& /*view*/) {}

  double weight() const { return weight_; }
  void divide_weight(double divisor) { weight_ /= divisor; }

  void find_scattered(const Vector& /*direction*/, const Vector& /*to_sun*/, Law law, double transmitted) {
    found_ += weight_ * (law / (4.0 * kPi) * transmitted);
  }
  void find_reflected(double radiance) { found_ += weight_ * radiance; }

  void scatter(const Vector& /*before*/, const Vector& /*after*/, double albedo, Law law, double density) {
    weight_ *= albedo * 0.5 * law / density;
  }
  void reflect(const Vector& /*after*/, double factor) { weight_ *= factor; }

  Found found(double first_weight) const { return first_weight * found_; }

 private:
  double weight_ = 1.0;  // relative to the first collision's
  double found_ = 0.0;
};

}  // namespace skylut::monte_carlo
