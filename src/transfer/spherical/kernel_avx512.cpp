#include "line_of_sight.hpp"

// Compiled for AVX512; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

SolvedBlock* solve_block_avx512(const SweepView& grid, const OpticsView& optics,
                                const IterationLimits& limits) {
  return solve_block<LaneRegister<16>::type>(grid, optics, limits);
}

}  // namespace skylut::transfer
