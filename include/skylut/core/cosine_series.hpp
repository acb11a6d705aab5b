#pragma once

#include <cstddef>
#include <vector>

namespace skylut {

/// The cosine transform of the first kind: the weights with which values at kπ/(count-1) make the
/// coefficients of cos mφ, c_m = 2/(count-1) Σ'' f_k cos(mkπ/(count-1)), the ends of the sum and the first
/// and last m by half.
/// @param count  at least 1; of one value it is the constant
/// @return [m][k]
std::vector<double> cosine_series(std::size_t count);

}  // namespace skylut
