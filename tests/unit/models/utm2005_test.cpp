#include "skylut/models/utm2005.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/test_context.hpp"

namespace skylut {
namespace {

// Of 54 legible rows, 40 have impossible chromaticities (one of them, 0.55, 0.17, only just beyond the line
// of purples), 43 have B > 0, and the 270 coefficients take 55 distinct values. docs/fit.md U2
TEST(Utm2005, CountsOfTheErrata) {
  const auto rows = load_utm2005(test::context);
  ASSERT_EQ(rows.size(), 54u);
  const auto verdicts = judge_utm2005(rows, ColourMatching::load(test::context));
  const auto count = [&](bool Utm2005Verdict::*failure) {
    return std::count_if(verdicts.begin(), verdicts.end(), [&](const auto& v) { return v.*failure; });
  };
  EXPECT_EQ(count(&Utm2005Verdict::impossible_chromaticity), 40);
  EXPECT_EQ(count(&Utm2005Verdict::infinite_horizon), 43);
  EXPECT_EQ(count(&Utm2005Verdict::dark_zenith), 0);
  // Every row whose mirror is legible differs from it.
  EXPECT_GT(count(&Utm2005Verdict::mirror_differs), 30);
  std::set<double> values;
  for (const Utm2005Row& row : rows)
    for (const double value : row.coefficients.values()) values.insert(value);
  EXPECT_EQ(values.size(), 55u);
}

TEST(Utm2005, VerdictInWords) {
  EXPECT_EQ(Utm2005Verdict{}.text(), "plausible");
  EXPECT_TRUE(Utm2005Verdict{}.plausible());
  const Utm2005Verdict verdict{true, false, true, false};
  EXPECT_EQ(verdict.text(), "chromaticity+mirror");
  EXPECT_FALSE(verdict.plausible());
}

}  // namespace
}  // namespace skylut
