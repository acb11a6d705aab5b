#include "skylut/models/perez_channel_sky.hpp"

#include "skylut/core/constants.hpp"

namespace skylut {

void PerezChannelSky::values(const Direction& view, std::span<double> values) const {
  const double cos_zenith = std::cos(view.zenith_deg * kRadiansPerDegree);
  const double gamma_rad = angle_between(view, sun());
  const double cos_gamma = std::cos(gamma_rad);
  for (std::size_t i = 0; i < formulas_.size(); ++i) {
    const PerezCoefficients& c = formulas_[i].coefficients;
    values[i] = formulas_[i].scale * perez(c.A, c.B, c.C, c.D, c.E, cos_zenith, gamma_rad, cos_gamma);
  }
}

}  // namespace skylut
