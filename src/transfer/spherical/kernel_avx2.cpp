#include "line_of_sight.hpp"

// Compiled for AVX2; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

SolvedBlock* solve_block_avx2(const SweepView& grid, const OpticsView& optics,
                              const IterationLimits& limits) {
  return solve_block<LaneRegister<8>::type>(grid, optics, limits);
}

}  // namespace skylut::transfer
