#pragma once

#include <span>

#include "skylut/colour/yxy.hpp"

namespace skylut {

/// How far one sky is from another over a set of directions, each counting the same.
struct SkyDifference {
  double rmse_Y_rel = 0.0;  ///< root mean square of (Y - Y_ref) / Y_ref
  double rmse_x = 0.0;      ///< root mean square of x - x_ref
  double rmse_y = 0.0;      ///< root mean square of y - y_ref
  double mean_Y_rel = 0.0;  ///< mean of (Y - Y_ref) / Y_ref: the bias
};

/// @param sky        colours in the same unit as the reference
/// @param reference  Y > 0
/// @throws InputError  if the sizes differ, are 0, or a reference luminance is not > 0
SkyDifference difference(std::span<const Yxy> sky, std::span<const Yxy> reference);

}  // namespace skylut
