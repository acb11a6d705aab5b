#include "line_of_sight.hpp"

// Compiled for SSE2; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

SolvedBlock* solve_block_sse2(const SweepView& grid, const OpticsView& optics,
                              const IterationLimits& limits) {
  return solve_block<LaneRegister<4>::type>(grid, optics, limits);
}

}  // namespace skylut::transfer
