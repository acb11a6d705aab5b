#include "line_of_sight.hpp"

// Compiled for AVX512; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

bool run_block_avx512(const SweepView& grid, const OpticsView& optics, const IterationLimits& limits,
                      RayQueue& queue) {
  return run_block<LaneRegister<16>::type>(grid, optics, limits, queue);
}

}  // namespace skylut::transfer
