#include "kernel_choice.hpp"

#include "skylut/core/errors.hpp"

namespace skylut::transfer {

namespace {

constexpr Kernel kReference{.name = "reference", .lanes = 1, .solve_block = solve_block_reference};
constexpr Kernel kPortable{.name = "portable", .lanes = 4, .solve_block = solve_block_portable};

#if defined(SKYLUT_X86_KERNELS)
constexpr Kernel kAvx2{.name = "avx2", .lanes = 8, .solve_block = solve_block_avx2};
constexpr Kernel kAvx512{.name = "avx512", .lanes = 16, .solve_block = solve_block_avx512};

bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}

const Kernel& wide_kernel(Simd simd) {
  if (simd == Simd::best) return has_avx512() ? kAvx512 : has_avx2() ? kAvx2 : kPortable;
  if (simd == Simd::avx2 && !has_avx2())
    throw InputError("kernel avx2: this processor lacks AVX2 or FMA; best and portable run everywhere");
  if (simd == Simd::avx512 && !has_avx512())
    throw InputError(
        "kernel avx512: this processor lacks AVX-512 F, DQ, VL or BW; best and portable run "
        "everywhere");
  return simd == Simd::avx2 ? kAvx2 : kAvx512;
}
#else
const Kernel& wide_kernel(Simd simd) {
  if (simd == Simd::best) return kPortable;
  throw InputError("kernel {}: is for x86-64 processors; best and portable run everywhere",
                   simd == Simd::avx2 ? "avx2" : "avx512");
}
#endif

}  // namespace

const Kernel& kernel_for(Simd simd) {
  switch (simd) {
    case Simd::reference:
      return kReference;
    case Simd::portable:
      return kPortable;
    case Simd::best:
    case Simd::avx2:
    case Simd::avx512:
      return wide_kernel(simd);
  }
  return kPortable;
}

}  // namespace skylut::transfer
