#include "column_groups.hpp"

#include <algorithm>

namespace skylut::transfer {

std::vector<ColumnGroup> group_columns(const LayerMerge& merge, const DiscretisationOptions& options,
                                       std::span<const OpticalColumn> columns) {
  std::vector<ColumnGroup> groups;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const DiscretisationKey key = discretisation_for(merge, options, columns[column]);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ColumnGroup& known) { return known.key == key; });
    if (group == groups.end()) group = groups.insert(groups.end(), {key, {}});
    group->columns.push_back(column);
  }
  return groups;
}

}  // namespace skylut::transfer
