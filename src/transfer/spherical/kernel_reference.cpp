#include "solved_block.hpp"

// One lane of doubles: what the other builds are judged by. Slow.
namespace skylut::transfer {

SolvedBlock* solve_block_reference(const SweepView& grid, const OpticsView& optics,
                                   const IterationLimits& limits, IterationReport& report) {
  return solve_block<double>(grid, optics, limits, report);
}

}  // namespace skylut::transfer
