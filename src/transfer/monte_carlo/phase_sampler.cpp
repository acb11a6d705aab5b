#include "phase_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut::monte_carlo {
namespace {

constexpr int kBins = 4000;

}  // namespace

PhaseSampler::PhaseSampler(const PhaseFunction& phase) : phase_(&phase) {
  // Θ = π u²: the first bins are 1e-5° wide, the last 0.09°.
  for (int i = 0; i <= kBins; ++i) {
    const double u = static_cast<double>(i) / kBins;
    edge_.push_back(i == kBins ? -1.0 : std::cos(kPi * u * u));
  }
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < edge_.size(); ++i) {
    const double width = edge_[i] - edge_[i + 1];
    const double middle = 0.5 * (edge_[i] + edge_[i + 1]);
    const double simpson = (std::abs(phase.value(edge_[i])) + 4.0 * std::abs(phase.value(middle)) +
                            std::abs(phase.value(edge_[i + 1]))) /
                           6.0;
    // A share for every bin, also where p vanishes, keeps the draw unbiased.
    sum += width * std::max(simpson, 1e-6);
    cumulative_.push_back(sum);
  }
  for (double& share : cumulative_) share /= sum;
}

double PhaseSampler::draw(RandomStream& random) const {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, random.uniform());
  const auto bin = static_cast<std::size_t>(found - cumulative_.begin());
  return edge_[bin + 1] + (edge_[bin] - edge_[bin + 1]) * random.uniform();
}

double PhaseSampler::density(double cos_angle) const {
  const double angle = std::acos(std::clamp(cos_angle, -1.0, 1.0));
  const auto bin = std::min(static_cast<std::size_t>(kBins * std::sqrt(angle / kPi)), cumulative_.size() - 1);
  const double share = bin == 0 ? cumulative_[0] : cumulative_[bin] - cumulative_[bin - 1];
  return share / (edge_[bin] - edge_[bin + 1]);
}

}  // namespace skylut::monte_carlo
