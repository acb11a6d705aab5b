#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace skylut::compact {

/// e^x in single precision, relative error below 4e-7, without branches so that loops over it become vector
/// instructions: 2^n times a polynomial of the rest (minimax on ±½ ln 2). x is moved into ±80.
inline float fast_exp(float x) {
  x = std::min(80.0f, std::max(-80.0f, x));
  const float shifted = x * 1.44269504f + 12582912.0f;  // + 1.5·2²³ rounds to a whole number
  const auto n = static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(shifted) - 0x4B400000U);
  const float whole = shifted - 12582912.0f;
  const float f = (x - whole * 0.693359375f) + whole * 2.12194440e-4f;
  float p = 1.9875691500e-4f;
  p = p * f + 1.3981999507e-3f;
  p = p * f + 8.3334519073e-3f;
  p = p * f + 4.1665795894e-2f;
  p = p * f + 1.6666665459e-1f;
  p = p * f + 5.0000001201e-1f;
  p = p * f * f + f + 1.0f;
  return p * std::bit_cast<float>(static_cast<std::uint32_t>(n + 127) << 23);
}

/// arccos x, absolute error below 1e-6 rad, relative below 3e-5 at any angle above 0.1°. [Abramowitz & Stegun
/// 4.4.46]
inline float fast_acos(float x) {
  const float a = std::min(std::abs(x), 1.0f);
  float p = -0.0012624911f;
  p = p * a + 0.0066700901f;
  p = p * a - 0.0170881256f;
  p = p * a + 0.0308918810f;
  p = p * a - 0.0501743046f;
  p = p * a + 0.0889789874f;
  p = p * a - 0.2145988016f;
  p = p * a + 1.5707963050f;
  const float angle = p * std::sqrt(1.0f - a);
  return x < 0.0f ? 3.14159265f - angle : angle;
}

}  // namespace skylut::compact
