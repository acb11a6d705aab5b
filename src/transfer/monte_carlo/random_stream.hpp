#pragma once

#include <cstdint>
#include <random>

namespace skylut::monte_carlo {

/// Uniform numbers of one batch. mt19937_64 is fixed by the C++ standard; the distributions of the standard
/// library are not, so the numbers are made from its bits here: the same everywhere.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t view_key, std::uint64_t batch) {
    std::seed_seq sequence{low(seed), high(seed), low(view_key), high(view_key), low(batch), high(batch)};
    engine_.seed(sequence);
  }

  /// In [0, 1), 53 bits.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

 private:
  static std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
  static std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

  std::mt19937_64 engine_;
};

}  // namespace skylut::monte_carlo
