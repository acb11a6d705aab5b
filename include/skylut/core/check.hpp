#pragma once

#include <fmt/format.h>

/// Preconditions that only our own mistakes can break: a failed check says where, what and with which
/// operands, and ends the program. On in Debug builds and where the CMake option SKYLUT_CHECKS is ON (the
/// `sanitize` preset); no code at all in what users run. What a user can get wrong is an InputError, never a
/// check.
namespace skylut::detail {

/// Prints one line to standard error and aborts.
[[noreturn]] void check_failed(const char* file, int line, const char* condition, const char* operands);

template <class A, class B>
[[noreturn]] void check_failed(const char* file, int line, const char* condition, const A& a, const B& b) {
  check_failed(file, line, condition, fmt::format(" ({} against {})", a, b).c_str());
}

}  // namespace skylut::detail

#if defined(SKYLUT_CHECKS) || !defined(NDEBUG)
#define SKYLUT_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::skylut::detail::check_failed(__FILE__, __LINE__, #condition, ""))
#define SKYLUT_CHECK_OPERANDS(a, comparison, b) \
  (((a)comparison(b)) ? static_cast<void>(0)    \
                      : ::skylut::detail::check_failed(__FILE__, __LINE__, #a " " #comparison " " #b, a, b))
#else
#define SKYLUT_CHECK(condition) static_cast<void>(0)
#define SKYLUT_CHECK_OPERANDS(a, comparison, b) static_cast<void>(0)
#endif
#define SKYLUT_CHECK_EQ(a, b) SKYLUT_CHECK_OPERANDS(a, ==, b)
#define SKYLUT_CHECK_LT(a, b) SKYLUT_CHECK_OPERANDS(a, <, b)
#define SKYLUT_CHECK_LE(a, b) SKYLUT_CHECK_OPERANDS(a, <=, b)
#define SKYLUT_CHECK_GE(a, b) SKYLUT_CHECK_OPERANDS(a, >=, b)
