#include "skylut/compare/metrics.hpp"

#include <cmath>

#include "skylut/core/errors.hpp"

namespace skylut {

SkyDifference difference(std::span<const Yxy> sky, std::span<const Yxy> reference) {
  if (sky.size() != reference.size() || sky.empty())
    throw InputError("skies of {} and {} directions: must have as many, and at least one", sky.size(),
                     reference.size());
  SkyDifference sum;
  for (std::size_t i = 0; i < sky.size(); ++i) {
    if (!(reference[i].Y > 0.0))
      throw InputError("reference sky, direction {}: Y = {}: must be greater than 0", i, reference[i].Y);
    const double Y = (sky[i].Y - reference[i].Y) / reference[i].Y;
    const double x = sky[i].x - reference[i].x;
    const double y = sky[i].y - reference[i].y;
    sum.rmse_Y_rel += Y * Y;
    sum.rmse_x += x * x;
    sum.rmse_y += y * y;
    sum.mean_Y_rel += Y;
  }
  const auto count = static_cast<double>(sky.size());
  return {.rmse_Y_rel = std::sqrt(sum.rmse_Y_rel / count),
          .rmse_x = std::sqrt(sum.rmse_x / count),
          .rmse_y = std::sqrt(sum.rmse_y / count),
          .mean_Y_rel = sum.mean_Y_rel / count};
}

}  // namespace skylut
