#include "skylut/core/cosine_series.hpp"

#include <cmath>

#include "skylut/core/constants.hpp"

namespace skylut {

std::vector<double> cosine_series(std::size_t count) {
  if (count == 1) return {1.0};
  const auto steps = static_cast<double>(count - 1);
  std::vector<double> weights;
  for (std::size_t m = 0; m < count; ++m)
    for (std::size_t k = 0; k < count; ++k) {
      double weight = 2.0 / steps * std::cos(kPi * static_cast<double>(m * k) / steps);
      if (k == 0 || k + 1 == count) weight *= 0.5;
      if (m == 0 || m + 1 == count) weight *= 0.5;
      weights.push_back(weight);
    }
  return weights;
}

}  // namespace skylut
