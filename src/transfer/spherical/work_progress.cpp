#include "work_progress.hpp"

#include <ctime>

#include "skylut/core/context.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/parallel.hpp"

namespace skylut::transfer {

namespace {

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void WorkProgress::run(std::size_t count, std::size_t steps_each,
                       const std::function<void(std::size_t)>& task) {
  parallel_for(count, context_.threads, [&](std::size_t index) {
    if (context_.cancel.stop_requested()) throw Cancelled();
    const double start_s = thread_cpu_s();
    task(index);
    const std::scoped_lock lock(lock_);
    cpu_s_ += thread_cpu_s() - start_s;
    done_ += steps_each;
    if (context_.progress) context_.progress("solving the radiative transfer", done_, steps_);
  });
}

}  // namespace skylut::transfer
