#include "solved_block.hpp"

// Compiled for AVX2; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

SolvedBlock* solve_block_avx2(const SweepView& grid, const OpticsView& optics, const IterationLimits& limits,
                              IterationReport& report) {
  return solve_block<LaneRegister<8>::type>(grid, optics, limits, report);
}

}  // namespace skylut::transfer
