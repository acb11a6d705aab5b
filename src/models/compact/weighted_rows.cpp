#include "weighted_rows.hpp"

#include <algorithm>

#include "clones.hpp"

namespace skylut::compact {

namespace {

SKYLUT_CLONES void add_four(const float* weights, const float* rows, std::size_t width, float* to) {
  const float* second = rows + width;
  const float* third = second + width;
  const float* fourth = third + width;
  for (std::size_t i = 0; i < width; ++i)
    to[i] +=
        (weights[0] * rows[i] + weights[1] * second[i]) + (weights[2] * third[i] + weights[3] * fourth[i]);
}

SKYLUT_CLONES void sum_of_four(const float* weights, const float* rows, std::size_t width, float* to) {
  const float* second = rows + width;
  const float* third = second + width;
  const float* fourth = third + width;
  for (std::size_t i = 0; i < width; ++i)
    to[i] =
        (weights[0] * rows[i] + weights[1] * second[i]) + (weights[2] * third[i] + weights[3] * fourth[i]);
}

SKYLUT_CLONES void add_one(float weight, const float* row, std::size_t width, float* to) {
  for (std::size_t i = 0; i < width; ++i) to[i] += weight * row[i];
}

}  // namespace

void weighted_rows(std::span<const float> weights, const float* rows, std::span<float> to) {
  std::size_t r = 0;
  if (weights.size() >= 4) {
    sum_of_four(weights.data(), rows, to.size(), to.data());
    r = 4;
  } else {
    std::fill(to.begin(), to.end(), 0.0f);
  }
  for (; r + 4 <= weights.size(); r += 4)
    add_four(weights.data() + r, rows + r * to.size(), to.size(), to.data());
  for (; r < weights.size(); ++r) add_one(weights[r], rows + r * to.size(), to.size(), to.data());
}

}  // namespace skylut::compact
