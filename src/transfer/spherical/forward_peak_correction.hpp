#pragma once

#include <span>
#include <vector>

#include "skylut/scattering/phase_function.hpp"

namespace skylut::transfer {

/// Delta-M takes a share f = χ_{L+1} of the scattering, the forward peak, for light that goes straight on,
/// and single scattering is then computed with the whole phase function but the thinner medium. Near the sun
/// that is too bright: light scattered k times by the peak alone is counted as if once for each of the k, and
/// it is spread over the peak's own width. With p_l = χ_l/f beyond L (else 1), in small angles k scatterings
/// have the moments p_l^k, and k is a Poisson number with the mean m = depth of the peak on the whole way.
/// Counted once, the peak's part of the phase function has the moments
///   c_l e^-m (e^{m p_l} - 1)/(m p_l),   c_l = f p_l,
/// instead of c_l. The terms of order m and m² are kept: P - m Q1 + m² Q2/2. The term of order m is what the
/// IMS correction of Nakajima & Tanaka 1988 (eqs. 62-68) adds in plane layers. [theory.md §4.6, L5]
class ForwardPeakCorrection {
 public:
  /// @param max_l  L: the highest degree that is kept
  ForwardPeakCorrection(const PhaseFunction& phase, int max_l);

  /// Q1 = Σ (2l+1) c_l (1 - p_l/2) P_l(cosΘ), Q2 = Σ (2l+1) c_l (1 - p_l + p_l²/3) P_l(cosΘ).
  struct Coefficients {
    double first = 0.0;
    double second = 0.0;
  };
  /// @param legendre  P_l(cosΘ) for l < terms() at least; they serve every phase function
  Coefficients at(std::span<const double> legendre) const;
  std::size_t terms() const { return term_.size(); }

 private:
  std::vector<Coefficients> term_;  // by degree: factors of P_l
};

}  // namespace skylut::transfer
