#include "weighted_rows.hpp"

#include <algorithm>

// Clones are chosen when the program is loaded, before the address sanitizer is up.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SKYLUT_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define SKYLUT_CLONES
#endif

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

SKYLUT_CLONES void add_one(float weight, const float* row, std::size_t width, float* to) {
  for (std::size_t i = 0; i < width; ++i) to[i] += weight * row[i];
}

}  // namespace

void weighted_rows(std::span<const float> weights, const float* rows, std::span<float> to) {
  std::fill(to.begin(), to.end(), 0.0f);
  std::size_t r = 0;
  for (; r + 4 <= weights.size(); r += 4)
    add_four(weights.data() + r, rows + r * to.size(), to.size(), to.data());
  for (; r < weights.size(); ++r) add_one(weights[r], rows + r * to.size(), to.size(), to.data());
}

}  // namespace skylut::compact
