#pragma once

#include <cstddef>
#include <span>

namespace skylut::compact {

/// to[i] = Σ_r weights[r] rows[r][i]; rows follow one another, each as long as `to`. Compiled for AVX2 too
/// where the machine has it, with the same roundings: the same bits.
void weighted_rows(std::span<const float> weights, const float* rows, std::span<float> to);

}  // namespace skylut::compact
