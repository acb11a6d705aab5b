#pragma once

/// Compiles a function, and all that it calls, twice, for AVX2 too: the machine's loader chooses. Sums keep
/// their order and nothing is contracted, so that both give the same bits. Not under the address sanitizer,
/// which is not up yet when the loader chooses.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SKYLUT_CLONES __attribute__((target_clones("avx2", "default"), flatten))
#else
#define SKYLUT_CLONES
#endif
