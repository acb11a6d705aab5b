#include "solved_block.hpp"

// Compiled for AVX-512; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

SolvedBlock* solve_block_avx512(const SweepView& grid, const OpticsView& optics,
                                const IterationLimits& limits, IterationReport& report) {
  return solve_block<LaneRegister<16>::type>(grid, optics, limits, report);
}

}  // namespace skylut::transfer
