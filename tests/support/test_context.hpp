#pragma once

#include "skylut/core/context.hpp"

namespace skylut::test {

/// A context over the source tree's data that keeps nothing from run to run.
inline Context test_context() {
  Context context;
  context.data_folder = SKYLUT_TEST_PROFILES;
  return context;
}

inline const Context context = test_context();

/// The same on that many threads.
inline Context on_threads(int threads) {
  Context chosen = test_context();
  chosen.threads = threads;
  return chosen;
}

/// The same with that build of the solver.
inline Context with_simd(Simd simd) {
  Context chosen = test_context();
  chosen.simd = simd;
  return chosen;
}

}  // namespace skylut::test
