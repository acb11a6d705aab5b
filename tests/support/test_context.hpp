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

}  // namespace skylut::test
