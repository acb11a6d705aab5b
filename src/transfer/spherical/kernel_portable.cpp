#include "solved_block.hpp"

// Four lanes without instructions of one kind of machine; see CMakeLists.txt and lanes.hpp.
namespace skylut::transfer {

SolvedBlock* solve_block_portable(const SweepView& grid, const OpticsView& optics,
                                  const IterationLimits& limits, IterationReport& report) {
  return solve_block<LaneRegister<4>::type>(grid, optics, limits, report);
}

}  // namespace skylut::transfer
