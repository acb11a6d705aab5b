#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace skylut {

/// A line "solving the radiative transfer: 34 %, 2 s left" on standard error, rewritten in place; silent
/// unless standard error is a terminal. The line is gone when a stage is done and when the object is.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Not to be called by two threads at a time. Another stage than before begins anew.
  void show(std::string_view stage, std::size_t done, std::size_t all);

 private:
  using Clock = std::chrono::steady_clock;
  void clear();

  bool on_terminal_;
  std::string stage_;
  Clock::time_point start_{};
  Clock::time_point last_{};
  bool shown_ = false;
};

/// "34 %, 2 s left"; without the time as long as there is no evidence for it: the first parts of a work are
/// no sample of the rest, for threads begin together and tables are built first.
std::string progress_text(double elapsed_s, std::size_t done, std::size_t all);

}  // namespace skylut
