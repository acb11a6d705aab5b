#include "skylut/scattering/size_distribution.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

double SizeDistribution::per_log_radius(double radius_um) const {
  if (radius_um < r_min_um || radius_um > r_max_um) return 0.0;
  if (kind == Kind::power_law)
    return exponent * std::pow(radius_um, -exponent) /
           (std::pow(r_min_um, -exponent) - std::pow(r_max_um, -exponent));
  const double width = std::log(sigma_g);
  const double distance = std::log(radius_um / mode_radius_um) / width;
  return std::exp(-0.5 * distance * distance) / (std::sqrt(2.0 * kPi) * width);
}

}  // namespace skylut
