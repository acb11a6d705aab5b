#pragma once

#include <cstddef>
#include <functional>

namespace skylut {

/// How many threads are meant: `threads`, or one per core for 0 and less.
int thread_count(int threads);

/// Calls task(0) … task(count - 1), each once, on up to `threads` threads (0: all cores). Tasks must
/// be independent: the order is not fixed. The first exception thrown by a task is rethrown.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

}  // namespace skylut
