#pragma once

#include <span>
#include <vector>

#include "discretisation.hpp"

namespace skylut::transfer {

/// Columns that share a discretisation.
struct ColumnGroup {
  DiscretisationKey key;
  std::vector<std::size_t> columns;
};

/// Groups in order of first appearance.
std::vector<ColumnGroup> group_columns(const LayerMerge& merge, const DiscretisationOptions& options,
                                       std::span<const OpticalColumn> columns);

}  // namespace skylut::transfer
