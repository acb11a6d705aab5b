#include "table/branches.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "table/half_skies.hpp"

namespace skylut::table_detail {
namespace {

// Two ways to write nearly one sky: flat but for a narrow aureole, or but for a wide one.
const PerezCoefficients kOne{-0.9, -0.2, 5.0, -2.5, 0.4};
// Its gradation in another valley: halved with kOne, 1 + A e^{B/cosθ} changes its sign.
const PerezCoefficients kOther{-100.0, -4.8, 5.0, -2.5, 0.4};
const double kSun = 45.0 * kRadiansPerDegree;

BranchGrid line(std::vector<std::vector<Branch>> branches) {
  BranchGrid grid;
  grid.sizes = {branches.size(), 1, 1};
  grid.sun_zeniths_rad = {kSun};
  grid.branches = std::move(branches);
  return grid;
}

std::vector<double> logarithms(const PerezCoefficients& k) {
  std::vector<double> values = FormulaDome(kSun).relative(k);
  for (double& value : values) value = std::log(value);
  return values;
}

double misfit(const PerezCoefficients& one, const PerezCoefficients& other, double limit) {
  return half_misfit(FormulaDome(kSun), one, logarithms(one), other, logarithms(other), limit);
}

TEST(HalfSkies, TheDomesSkyIsTheFormulas) {
  const std::vector<double> values = FormulaDome(kSun).relative(kOne);
  EXPECT_NEAR(values.front(), 1.0, 1e-14);  // the zenith
  // The last direction is the horizon away from the sun, γ = 135°.
  EXPECT_NEAR(values.back(), perez_relative(kOne, 0.5 * kPi, 0.75 * kPi, kSun), 1e-12);
}

TEST(HalfSkies, OfEqualRowsNothingIsOff) {
  EXPECT_NEAR(misfit(kOne, kOne, 1.0), 0.0, 1e-24);
  EXPECT_GT(misfit(kOne, {-0.5, -0.2, 5.0, -2.5, 0.4}, 5.0), 1e-4);
}

TEST(HalfSkies, SeesHalvesThatAreNotPositiveOrTooFarOff) {
  EXPECT_GE(misfit(kOne, kOther, 1e3), kImpossibleHalf);
  const PerezCoefficients brighter{-0.5, -0.2, 5.0, -2.5, 0.4};
  EXPECT_LT(misfit(kOne, brighter, 1.0), kImpossibleHalf);
  EXPECT_GE(misfit(kOne, brighter, 1e-3), kImpossibleHalf);
}

TEST(Branches, TheNeighboursBranchIsTakenAmongEquals) {
  // In the middle the other valley is cheaper by half a percent.
  const ChosenBranches chosen = choose_branches(line({{{kOne}}, {{kOther}, {kOne, 0.005}}, {{kOne}}}));
  EXPECT_EQ(chosen.branch, (std::vector<std::size_t>{0, 1, 0}));
  EXPECT_EQ(chosen.beside_impossible, (std::vector<bool>{false, false, false}));
}

TEST(Branches, OfEqualHalvesTheCheapest) {
  const ChosenBranches chosen = choose_branches(line({{{kOne}}, {{kOne}, {kOne, 0.005}}}));
  EXPECT_EQ(chosen.branch, (std::vector<std::size_t>{0, 0}));
}

// A worse fit is taken where the half would be impossible otherwise, not to make a possible one nearer.
TEST(Branches, WorseOnesOnlyWhereNothingElseWillDo) {
  const PerezCoefficients near{-0.85, -0.2, 5.0, -2.5, 0.4};
  EXPECT_EQ(choose_branches(line({{{kOne}}, {{near}, {kOne, 0.5, false}}})).branch[1], 0u);
  EXPECT_EQ(choose_branches(line({{{kOne}}, {{kOther}, {kOne, 0.5, false}}})).branch[1], 1u);
}

TEST(Branches, SaysWhereHalvesStayImpossible) {
  const ChosenBranches chosen = choose_branches(line({{{kOne}}, {{kOther}}, {{kOther}}}));
  EXPECT_EQ(chosen.beside_impossible, (std::vector<bool>{true, true, false}));
}

// A grid of 2 × 2 × 2: every corner but one has both branches, and that one drags all to its own.
TEST(Branches, AllAxesCount) {
  BranchGrid grid;
  grid.sizes = {2, 2, 2};
  grid.sun_zeniths_rad = {kSun, kSun + 0.1};
  grid.branches.assign(8, {{kOther}, {kOne, 0.001}});
  grid.branches[7] = {{kOne}};
  const ChosenBranches chosen = choose_branches(grid);
  EXPECT_EQ(chosen.branch, (std::vector<std::size_t>{1, 1, 1, 1, 1, 1, 1, 0}));
}

}  // namespace
}  // namespace skylut::table_detail
