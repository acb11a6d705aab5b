#include "skylut/colour/rgb_space.hpp"

#include <gtest/gtest.h>

#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

// Columns of the matrix from RGB to XYZ are the colours of the primaries.
void expect_columns(const RgbConversion& conversion, const std::array<std::array<double, 3>, 3>& published,
                    double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Xyz primary =
        conversion.to_xyz(LinearRgb{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0});
    EXPECT_NEAR(primary.X, published[0][i], tolerance);
    EXPECT_NEAR(primary.Y, published[1][i], tolerance);
    EXPECT_NEAR(primary.Z, published[2][i], tolerance);
  }
}

// The matrices as their documents print them, to the digits printed.
TEST(RgbSpace, MatricesArePublishedOnes) {
  // SMPTE ST 2065-1:2021 §5.1; no adaptation there.
  expect_columns(RgbConversion(rgb_space("aces2065-1"), WhiteAdaptation::none),
                 {{{0.9525523959, 0.0, 0.0000936786},
                   {0.3439664498, 0.7281660966, -0.0721325464},
                   {0.0, 0.0, 1.0088251844}}},
                 1e-10);
  // Academy S-2014-004 appendix; also in ctl's ACESlib.
  expect_columns(RgbConversion(rgb_space("acescg"), WhiteAdaptation::none),
                 {{{0.6624541811, 0.1340042065, 0.1561876870},
                   {0.2722287168, 0.6740817658, 0.0536895174},
                   {-0.0055746495, 0.0040607335, 1.0103391003}}},
                 1e-10);
  // ITU-R BT.2087-0 (2015) §2.
  expect_columns(RgbConversion(rgb_space("rec2020")),
                 {{{0.6370, 0.1446, 0.1689}, {0.2627, 0.6780, 0.0593}, {0.0, 0.0281, 1.0610}}}, 5.1e-5);
  // IEC 61966-2-1:1999 eq. 8.
  expect_columns(RgbConversion(rgb_space("rec709")),
                 {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}}, 5.1e-5);
}

TEST(RgbSpace, LuminanceWeightsArePublishedOnes) {
  // SMPTE EG 432-1:2010 annex H prints Y = 0.2290, 0.6917, 0.0793 for P3 with D65.
  const LinearRgb p3 = RgbConversion(rgb_space("p3")).luminance_weights();
  EXPECT_NEAR(p3.r, 0.2290, 5e-5);
  EXPECT_NEAR(p3.g, 0.6917, 5e-5);
  EXPECT_NEAR(p3.b, 0.0793, 5e-5);
}

TEST(RgbSpace, Rec709IsThatOfYxy) {
  const Xyz colour{0.3, 0.5, 0.7};
  const LinearRgb one = RgbConversion(rgb_space("rec709")).to_rgb(colour);
  const LinearRgb other = to_linear_srgb(colour);
  EXPECT_NEAR(one.r, other.r, 1e-15);
  EXPECT_NEAR(one.g, other.g, 1e-15);
  EXPECT_NEAR(one.b, other.b, 1e-15);
}

TEST(RgbSpace, RoundTripsAreExactToRounding) {
  const Xyz colour{0.2, 1.3, 4.5};
  for (const RgbSpace& space : rgb_spaces())
    for (const WhiteAdaptation adaptation : {WhiteAdaptation::bradford, WhiteAdaptation::none}) {
      const RgbConversion conversion(space, adaptation);
      const LinearRgb rgb = conversion.to_rgb(colour);
      const Xyz back = conversion.to_xyz(rgb);
      EXPECT_NEAR(back.X, colour.X, 1e-14) << space.name;
      EXPECT_NEAR(back.Y, colour.Y, 1e-14) << space.name;
      EXPECT_NEAR(back.Z, colour.Z, 1e-14) << space.name;
      const LinearRgb weight = conversion.luminance_weights();
      EXPECT_NEAR(weight.r * rgb.r + weight.g * rgb.g + weight.b * rgb.b, colour.Y, 1e-14) << space.name;
    }
}

// D65 is neutral in every space when adapted; without, only where it is the white.
TEST(RgbSpace, AdaptedD65IsNeutral) {
  const Xyz d65 = to_xyz(Yxy{1.0, kD65_x, kD65_y});
  for (const RgbSpace& space : rgb_spaces()) {
    const LinearRgb adapted = RgbConversion(space).to_rgb(d65);
    EXPECT_NEAR(adapted.r, 1.0, 1e-14) << space.name;
    EXPECT_NEAR(adapted.g, 1.0, 1e-14) << space.name;
    EXPECT_NEAR(adapted.b, 1.0, 1e-14) << space.name;
  }
  const LinearRgb own = RgbConversion(rgb_space("acescg"), WhiteAdaptation::none).to_rgb(d65);
  EXPECT_GT(own.b, own.r + 0.05);
}

// OpenColorIO and colour-science go from AP1 to Rec. 709 by Bradford's adaptation; their matrix, to 6 digits.
TEST(RgbSpace, AcescgTurnsIntoRec709AsInAcesPrograms) {
  const Xyz red = RgbConversion(rgb_space("acescg")).to_xyz(LinearRgb{1.0, 0.0, 0.0});
  const LinearRgb in_rec709 = RgbConversion(rgb_space("rec709")).to_rgb(red);
  EXPECT_NEAR(in_rec709.r, 1.705051, 2e-6);
  EXPECT_NEAR(in_rec709.g, -0.130256, 2e-6);
  EXPECT_NEAR(in_rec709.b, -0.024003, 2e-6);
}

TEST(RgbSpace, UnknownNamesAreRefused) {
  EXPECT_THROW(rgb_space("srgb"), InputError);
  EXPECT_THROW(rgb_space(""), InputError);
}

}  // namespace
}  // namespace skylut
