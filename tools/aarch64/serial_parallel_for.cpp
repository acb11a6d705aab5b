#include "skylut/core/parallel.hpp"

// In place of src/core/parallel.cpp where no TBB is at hand.
namespace skylut {

void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = 0; i < count; ++i) task(i);
}

}  // namespace skylut
