#pragma once

#include <vector>

#include "random_stream.hpp"
#include "skylut/optics/phase_function.hpp"

namespace skylut::monte_carlo {

/// Draws scattering angles for any phase function: bins in cosΘ, narrow towards the forward direction, are
/// chosen by their share of |p|, the angle within a bin uniformly, and the weight p/q makes the draw exact.
class PhaseSampler {
 public:
  explicit PhaseSampler(const PhaseFunction& phase);

  struct Sample {
    double cos_angle = 1.0;
    double weight = 1.0;  ///< near 1; negative where a truncated Legendre series is
  };
  Sample draw(RandomStream& random) const;

  double value(double cos_angle) const { return phase_->value(cos_angle); }

 private:
  const PhaseFunction* phase_;
  std::vector<double> edge_;        ///< cosΘ, from 1 down to -1
  std::vector<double> cumulative_;  ///< share of the bins up to and with this one
};

}  // namespace skylut::monte_carlo
