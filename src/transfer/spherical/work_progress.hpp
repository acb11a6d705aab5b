#pragma once

#include <cstddef>
#include <functional>
#include <mutex>

namespace skylut {
struct Context;
}

namespace skylut::transfer {

/// Runs tasks in parallel, counts their CPU time, tells how much is done and stops when asked to.
class WorkProgress {
 public:
  /// @param steps  of all tasks together
  WorkProgress(const Context& context, std::size_t steps) : context_(context), steps_(steps) {}

  /// @throws Cancelled  when the context asks to stop
  void run(std::size_t count, std::size_t steps_each, const std::function<void(std::size_t)>& task);

  double cpu_s() const { return cpu_s_; }

 private:
  const Context& context_;
  std::size_t steps_;
  std::mutex lock_;
  std::size_t done_ = 0;
  double cpu_s_ = 0.0;
};

}  // namespace skylut::transfer
