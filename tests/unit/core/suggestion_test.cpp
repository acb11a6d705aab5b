#include "skylut/core/suggestion.hpp"

#include <gtest/gtest.h>

namespace skylut {
namespace {

const std::vector<std::string> kOptions{"--sun-zenith-deg", "--sun-azimuth-deg", "--turbidity",
                                        "--turbidity-kind", "--profile",         "--size",
                                        "--latitude"};

TEST(Suggestion, FindsTheWordBehindATypingError) {
  EXPECT_EQ(nearest("--turbidty", kOptions), "--turbidity");
  EXPECT_EQ(nearest("--sun-azimut-deg", kOptions), "--sun-azimuth-deg");
  EXPECT_EQ(nearest("--Profile", kOptions), "--profile");
}

TEST(Suggestion, FindsTheWordThatBeginsSo) {
  EXPECT_EQ(nearest("--sun-zenith", kOptions), "--sun-zenith-deg");
  EXPECT_EQ(nearest("--lat", kOptions), "--latitude");
}

TEST(Suggestion, FindsTheWordThatContainsIt) { EXPECT_EQ(nearest("azimuth", kOptions), "--sun-azimuth-deg"); }

TEST(Suggestion, IsSilentAboutOtherWords) {
  EXPECT_EQ(nearest("--colour-depth", kOptions), "");
  EXPECT_EQ(nearest("x", kOptions), "");
  EXPECT_EQ(suggested("--colour-depth", kOptions), "");
  EXPECT_EQ(suggested("--siez", kOptions), ", did you mean --size?");
}

TEST(Suggestion, ListsWords) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace skylut
