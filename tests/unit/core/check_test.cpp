// Whatever the build: what is tested are the checks themselves.
#undef SKYLUT_CHECKS
#define SKYLUT_CHECKS
#include "skylut/core/check.hpp"

#include <gtest/gtest.h>

namespace skylut {
namespace {

TEST(Check, SaysWhereWhatAndWithWhichOperands) {
  const int layers = 3;
  EXPECT_DEATH(SKYLUT_CHECK_LT(layers, 2),
               "^skylut: .*check_test.cpp:[0-9]+: check failed: layers < 2 .3 against 2.");
  EXPECT_DEATH(SKYLUT_CHECK(layers == 4), "check failed: layers == 4\n$");
}

TEST(Check, HoldsItsPeaceAndAsksOnce) {
  int asked = 0;
  SKYLUT_CHECK_EQ(++asked, 1);
  SKYLUT_CHECK_LE(1.0, 1.0);
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace skylut
