#pragma once

#include <span>

#include "column_groups.hpp"
#include "kernel_problem.hpp"
#include "lines_of_sight.hpp"
#include "skylut/transfer/transfer_cost.hpp"
#include "sun_bands.hpp"

namespace skylut {
struct Context;
}

namespace skylut::transfer {

/// Diffuse fields kept at a time; a field of the default table takes 7 MB.
inline constexpr std::size_t kKeptFields_bytes = std::size_t{256} << 20;

/// Everything that the amount of work follows from.
struct Work {
  Work(const Context& context, const Shells& shells, std::span<const OpticalColumn> columns,
       std::span<const Sight> sights, const TransferOptions& options);

  const Shells& shells;
  LayerMerge merge;
  std::span<const OpticalColumn> columns;
  std::size_t sights;
  const TransferOptions& options;
  const Kernel& kernel;
  int threads;
  std::vector<SunBand> bands;  ///< all that there are
};

/// @param lines  of every band
TransferCost estimate(const Work& work, const std::vector<ColumnGroup>& groups,
                      const std::vector<std::vector<LineOfSight>>& lines);

/// Refuses what the machine cannot hold, and what would take more than half an hour for one block.
/// @throws InputError  what needs how much, what there is, and what would fit
void refuse_too_much(const Work& work, const TransferCost& cost);

}  // namespace skylut::transfer
