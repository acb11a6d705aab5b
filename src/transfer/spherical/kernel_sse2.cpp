#include "line_of_sight.hpp"

// Compiled for SSE2; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

bool run_block_sse2(const SweepView& grid, const OpticsView& optics, const IterationLimits& limits,
                    RayQueue& queue) {
  return run_block<LaneRegister<4>::type>(grid, optics, limits, queue);
}

}  // namespace skylut::transfer
