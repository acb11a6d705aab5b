#include "skylut/report/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace skylut {

std::string progress_text(double elapsed_s, std::size_t done, std::size_t all) {
  constexpr double kEvidence_s = 1.0;
  constexpr double kEvidencePart = 0.05;
  const double part = all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
  std::string text = fmt::format("{:.0f} %", 100.0 * part);
  if (elapsed_s >= kEvidence_s && part >= kEvidencePart)
    text += fmt::format(", {:.0f} s left", elapsed_s * (1.0 - part) / part);
  return text;
}

Progress::Progress() : on_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
}

void Progress::show(std::string_view stage, std::size_t done, std::size_t all) {
  if (!on_terminal_) return;
  const Clock::time_point now = Clock::now();
  if (stage != stage_) {
    stage_ = stage;
    start_ = now;
  }
  if (done >= all) return clear();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r\x1b[K{}: {}", stage_, progress_text(elapsed_s, done, all));
  std::fflush(stderr);
}

}  // namespace skylut
