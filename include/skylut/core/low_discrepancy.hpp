#pragma once

#include <cstddef>

namespace skylut {

/// Van der Corput's sequence, the digits of i in a base mirrored at the point: evenly spread over [0, 1), in
/// several dimensions with a prime for each (Halton 1960, doi:10.1007/BF01386213). 0 for i = 0.
/// @param base  at least 2
constexpr double low_discrepancy(std::size_t i, std::size_t base) {
  double digit = 1.0;
  double value = 0.0;
  for (; i > 0; i /= base) {
    digit /= static_cast<double>(base);
    value += digit * static_cast<double>(i % base);
  }
  return value;
}

}  // namespace skylut
