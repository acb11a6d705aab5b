#include "view_list.hpp"

#include <map>

namespace skylut::plane_parallel {

ViewList::ViewList(std::span<const PlaneDirection> directions) {
  std::map<double, std::size_t> known;
  for (const PlaneDirection& direction : directions) {
    const auto [found, is_new] = known.try_emplace(direction.cos_view, cosines.size());
    if (is_new) cosines.push_back(direction.cos_view);
    of_direction.push_back(found->second);
  }
}

}  // namespace skylut::plane_parallel
