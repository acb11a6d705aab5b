#pragma once

#include <vector>

#include "random_stream.hpp"
#include "skylut/scattering/phase_function.hpp"

namespace skylut::monte_carlo {

/// Draws scattering angles for any phase function: bins in cosΘ, narrow towards the forward direction, are
/// chosen by their share of |p|, the angle within a bin uniformly. What is drawn follows density(), close
/// to p/2; the weight (p/2)/density makes an estimate exact.
class PhaseSampler {
 public:
  explicit PhaseSampler(const PhaseFunction& phase);

  /// cosΘ
  double draw(RandomStream& random) const;

  /// Of the draw, per unit cosΘ; its integral over -1 … 1 is 1.
  double density(double cos_angle) const;

  double value(double cos_angle) const { return phase_->value(cos_angle); }
  const PhaseFunction& phase() const { return *phase_; }

 private:
  const PhaseFunction* phase_;
  std::vector<double> edge_;        ///< cosΘ, from 1 down to -1
  std::vector<double> cumulative_;  ///< share of the bins up to and with this one
};

}  // namespace skylut::monte_carlo
