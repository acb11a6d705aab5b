#include "skylut/colour/yxy.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

TEST(Yxy, RoundTrips) {
  for (const Yxy& colour : {Yxy{1.0, 0.3127, 0.3290}, Yxy{4500.0, 0.23, 0.24}, Yxy{1e-6, 0.6, 0.35}}) {
    const Yxy back = to_yxy(to_xyz(colour));
    EXPECT_NEAR(back.Y, colour.Y, 1e-15 * colour.Y);
    EXPECT_NEAR(back.x, colour.x, 1e-15);
    EXPECT_NEAR(back.y, colour.y, 1e-15);
    const Xyz xyz = to_xyz(colour);
    const Xyz through_rgb = to_xyz(to_linear_srgb(xyz));
    // Condition of the matrix times rounding.
    EXPECT_NEAR(through_rgb.X, xyz.X, 1e-14 * colour.Y);
    EXPECT_NEAR(through_rgb.Y, xyz.Y, 1e-14 * colour.Y);
    EXPECT_NEAR(through_rgb.Z, xyz.Z, 2e-14 * colour.Y);
  }
}

TEST(Yxy, BlackHasTheChromaticityOfWhiteAndStaysBlack) {
  const Yxy black = to_yxy(Xyz{});
  EXPECT_EQ(black, (Yxy{0.0, kD65_x, kD65_y}));
  EXPECT_EQ(to_xyz(black), Xyz{});
  EXPECT_EQ(to_xyz(Yxy{0.0, 0.3, 0.0}), Xyz{});
  EXPECT_THROW(to_xyz(Yxy{1.0, 0.3, 0.0}), InputError);
}

TEST(LinearSrgb, WhiteAndPrimaries) {
  const LinearRgb white = to_linear_srgb(to_xyz(Yxy{1.0, kD65_x, kD65_y}));
  EXPECT_NEAR(white.r, 1.0, 1e-14);
  EXPECT_NEAR(white.g, 1.0, 1e-14);
  EXPECT_NEAR(white.b, 1.0, 1e-14);
  const Yxy red = to_yxy(to_xyz(LinearRgb{1.0, 0.0, 0.0}));
  EXPECT_NEAR(red.x, 0.64, 1e-14);
  EXPECT_NEAR(red.y, 0.33, 1e-14);
}

// IEC 61966-2-1:1999 prints the matrix XYZ to RGB to 4 decimals.
TEST(LinearSrgb, MatrixOfTheStandard) {
  const LinearRgb X = to_linear_srgb(Xyz{1.0, 0.0, 0.0});
  const LinearRgb Y = to_linear_srgb(Xyz{0.0, 1.0, 0.0});
  const LinearRgb Z = to_linear_srgb(Xyz{0.0, 0.0, 1.0});
  // The standard inverts its own 4-digit forward matrix, so its last digit is off by up to 4.
  constexpr double kPrinted = 4e-4;
  EXPECT_NEAR(X.r, 3.2406, kPrinted);
  EXPECT_NEAR(Y.r, -1.5372, kPrinted);
  EXPECT_NEAR(Z.r, -0.4986, kPrinted);
  EXPECT_NEAR(X.g, -0.9689, kPrinted);
  EXPECT_NEAR(Y.g, 1.8758, kPrinted);
  EXPECT_NEAR(Z.g, 0.0415, kPrinted);
  EXPECT_NEAR(X.b, 0.0557, kPrinted);
  EXPECT_NEAR(Y.b, -0.2040, kPrinted);
  EXPECT_NEAR(Z.b, 1.0570, kPrinted);
}

}  // namespace
}  // namespace skylut
