#include "forward_peak_correction.hpp"

#include <algorithm>
#include <cmath>

namespace skylut::transfer {

namespace {

// A peak as small as this needs no correction.
constexpr double kLeastPeak = 1e-3;
// Terms are summed until a moment has fallen to this share of the peak: the rest is felt within a degree of
// the sun at most.
constexpr double kLeastShare = 2e-3;
constexpr int kMostTerms = 600;

}  // namespace

ForwardPeakCorrection::ForwardPeakCorrection(const PhaseFunction& phase, int max_l) {
  const double peak = phase.moment(max_l + 1);
  if (peak < kLeastPeak) return;
  for (int l = 0; l <= kMostTerms; ++l) {
    const double p = l <= max_l ? 1.0 : phase.moment(l) / peak;
    if (std::abs(p) < kLeastShare) break;
    const double whole = (2.0 * l + 1.0) * peak * p;
    term_.push_back({whole * (1.0 - p / 2.0), whole * (1.0 - p + p * p / 3.0)});
  }
}

ForwardPeakCorrection::Coefficients ForwardPeakCorrection::at(std::span<const double> legendre) const {
  Coefficients sum;
  for (std::size_t l = 0; l < term_.size(); ++l) {
    sum.first += term_[l].first * legendre[l];
    sum.second += term_[l].second * legendre[l];
  }
  return sum;
}

}  // namespace skylut::transfer
