#include "skylut/report/progress.hpp"

#include <gtest/gtest.h>

namespace skylut {
namespace {

TEST(Progress, NamesNoTimeBeforeThereIsEvidence) {
  EXPECT_EQ(progress_text(0.9, 50, 100), "50 %");  // too soon
  EXPECT_EQ(progress_text(10.0, 4, 100), "4 %");   // too little done
  EXPECT_EQ(progress_text(10.0, 0, 100), "0 %");
  EXPECT_EQ(progress_text(1.0, 5, 100), "5 %, 19 s left");
  EXPECT_EQ(progress_text(6.0, 50, 100), "50 %, 6 s left");
}

}  // namespace
}  // namespace skylut
