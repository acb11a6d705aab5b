#include <cstdlib>
#include <string_view>

#include "kernel_problem.hpp"
#include "skylut/core/errors.hpp"

namespace skylut::transfer {

const Kernel& best_kernel() {
  static constexpr Kernel kKernels[] = {
      {"avx512", 16, solve_block_avx512}, {"avx2", 8, solve_block_avx2}, {"sse2", 4, solve_block_sse2}};
  const bool available[] = {__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                                __builtin_cpu_supports("avx512vl"),
                            __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"), true};
  const char* wanted = std::getenv("SKYLUT_SIMD");
  for (int i = 0; i < 3; ++i)
    if (available[i] && (wanted == nullptr || std::string_view(wanted) == kKernels[i].instruction_set))
      return kKernels[i];
  throw InputError("SKYLUT_SIMD={}: must be sse2, avx2 or avx512, and this machine must have it", wanted);
}

}  // namespace skylut::transfer
