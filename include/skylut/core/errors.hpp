#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace skylut {

/// The request was wrong: names the input, its value and what would be right, in one line.
/// The program prints it and ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}

  template <typename... Args>
  explicit InputError(fmt::format_string<Args...> format, Args&&... args)
      : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// The request was fine but the work failed (disk full, no convergence, a class of problem
/// that the solver cannot do). The program prints it and ends with exit code 1.
class WorkError : public std::runtime_error {
 public:
  explicit WorkError(const std::string& message) : std::runtime_error(message) {}

  template <typename... Args>
  explicit WorkError(fmt::format_string<Args...> format, Args&&... args)
      : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// The caller asked to stop (Context::cancel).
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace skylut
