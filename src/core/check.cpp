#include "skylut/core/check.hpp"

#include <cstdio>
#include <cstdlib>

namespace skylut::detail {

void check_failed(const char* file, int line, const char* condition, const char* operands) {
  std::fprintf(stderr, "skylut: %s:%d: check failed: %s%s\n", file, line, condition, operands);
  std::abort();
}

}  // namespace skylut::detail
