#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace skylut::cli {

Progress::Progress(std::string what) : what_(std::move(what)), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(std::size_t done, std::size_t all) {
  const Clock::time_point now = Clock::now();
  if (!on_terminal_ || done == 0 || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double left_s = elapsed_s * static_cast<double>(all - done) / static_cast<double>(done);
  fmt::print(stderr, "\r\x1b[K{} {:.0f} %, {:.0f} s left", what_,
             100.0 * static_cast<double>(done) / static_cast<double>(all), left_s);
  std::fflush(stderr);
}

}  // namespace skylut::cli
