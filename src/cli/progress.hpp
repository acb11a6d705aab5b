#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace skylut::cli {

/// A line "solving 34 %, 2 s left" on standard error, rewritten in place; silent unless standard
/// error is a terminal. The line is gone when the object is.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Not to be called by two threads at a time.
  void show(std::size_t done, std::size_t all);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  bool on_terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_{};
};

}  // namespace skylut::cli
