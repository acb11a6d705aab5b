#include "skylut/colour/cie1931.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

const ColourMatching& matching() {
  static const ColourMatching loaded = ColourMatching::load(test::context);
  return loaded;
}

std::vector<double> sampled(const WavelengthGrid& grid, double (*spectrum)(double)) {
  std::vector<double> values;
  for (const double wavelength : grid.values_nm()) values.push_back(spectrum(wavelength));
  return values;
}

// CIE 15:2004 table T.1, illuminant D65, every 10 nm from 380 nm; the 5 nm table is its linear interpolation.
double d65(double wavelength_nm) {
  constexpr std::array<double, 41> kTable{
      49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923,
      108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046, 100.000, 96.3342, 95.7880, 88.6856,
      90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091,
      74.3490, 61.6040, 69.8856, 75.0870, 63.5927, 46.4182, 66.8054, 63.3828};
  const double at = (wavelength_nm - 380.0) / 10.0;
  const auto i = std::min(static_cast<std::size_t>(at), kTable.size() - 2);
  const double t = at - static_cast<double>(i);
  return (1.0 - t) * kTable[i] + t * kTable[i + 1];
}

double equal_energy(double) { return 1.0; }
double slope(double wavelength_nm) { return wavelength_nm / 555.0; }

TEST(Cie1931, IntegralOfYBar) {
  double sum = 0.0;
  for (const Xyz& value : matching().values()) sum += 5.0 * value.Y;
  EXPECT_NEAR(sum, 106.857, 1e-3);
}

// Luminance of 1 W m⁻² sr⁻¹ nm⁻¹ at all wavelengths: 683.002 × 106.857; 380-780 nm lacks 6e-5 of ȳ.
TEST(Cie1931, LuminanceOfEqualEnergy) {
  const WavelengthGrid grid(360.0, 830.0, 5.0);
  const Xyz white = matching().integrate(grid, sampled(grid, equal_energy));
  EXPECT_NEAR(white.Y, kLuminousEfficacy_lm_per_W * 106.857, 1.0);
  const WavelengthGrid visible = WavelengthGrid::visible();
  EXPECT_NEAR(matching().integrate(visible, sampled(visible, equal_energy)).Y / white.Y, 1.0, 1e-4);
}

TEST(Cie1931, EqualEnergyWhiteIsOneThird) {
  const WavelengthGrid grid(360.0, 830.0, 5.0);
  const Yxy white = to_yxy(matching().integrate(grid, sampled(grid, equal_energy)));
  // CIE 15:2004: the sums of x̄, ȳ, z̄ differ by up to 3.4e-4 of themselves.
  EXPECT_NEAR(white.x, 1.0 / 3.0, 1e-4);
  EXPECT_NEAR(white.y, 1.0 / 3.0, 1e-4);
}

TEST(Cie1931, D65) {
  const WavelengthGrid grid = WavelengthGrid::visible();
  const Yxy white = to_yxy(matching().integrate(grid, sampled(grid, d65)));
  EXPECT_NEAR(white.x, 0.3127, 5e-5);
  EXPECT_NEAR(white.y, 0.3290, 5e-5);
}

// The same smooth spectrum on other grids: on finer ones, or on ones that divide 5 nm, the only difference is
// the trapezoidal rule on a piecewise linear table; a coarser one interpolates the spectrum, here exactly.
TEST(Cie1931, OtherGridsGiveTheSameColour) {
  const WavelengthGrid reference(380.0, 780.0, 5.0);
  const Xyz expected = matching().integrate(reference, sampled(reference, slope));
  for (const double step : {1.0, 2.0, 2.5, 4.0, 8.0, 10.0, 16.0, 20.0, 40.0, 80.0}) {
    const WavelengthGrid grid(380.0, 780.0, step);
    const Xyz colour = matching().integrate(grid, sampled(grid, slope));
    EXPECT_NEAR(colour.X / expected.X, 1.0, 1e-4) << step;
    EXPECT_NEAR(colour.Y / expected.Y, 1.0, 1e-4) << step;
    EXPECT_NEAR(colour.Z / expected.Z, 1.0, 1e-4) << step;
  }
}

TEST(Cie1931, OneWavelengthIsALine) {
  const std::vector<double> line{2.0};
  const Xyz colour = matching().integrate(WavelengthGrid(555.0, 555.0, 5.0), line);
  EXPECT_NEAR(colour.Y, kLuminousEfficacy_lm_per_W * 5.0 * 2.0 * matching().at(555.0).Y, 1e-9);
  EXPECT_THROW(matching().integrate(WavelengthGrid::visible(), line), InputError);
}

TEST(Cie1931, NoColourOutsideTheTable) {
  EXPECT_EQ(matching().at(300.0), Xyz{});
  EXPECT_EQ(matching().at(900.0), Xyz{});
  EXPECT_GT(matching().at(830.0).X, 0.0);
  EXPECT_NEAR(matching().at(557.5).Y, 0.5 * (matching().at(555.0).Y + matching().at(560.0).Y), 1e-15);
}

TEST(Cie1931, SpectralLocus) {
  EXPECT_TRUE(matching().inside_spectral_locus(1.0 / 3.0, 1.0 / 3.0));
  EXPECT_TRUE(matching().inside_spectral_locus(0.3127, 0.3290));
  EXPECT_TRUE(matching().inside_spectral_locus(0.64, 0.33));
  // On the border: every monochromatic light.
  for (const Xyz& value : matching().values()) {
    const Yxy spectral = to_yxy(value);
    EXPECT_TRUE(matching().inside_spectral_locus(1.0 / 3.0 + 0.999 * (spectral.x - 1.0 / 3.0),
                                                 1.0 / 3.0 + 0.999 * (spectral.y - 1.0 / 3.0)));
    EXPECT_FALSE(matching().inside_spectral_locus(1.0 / 3.0 + 1.01 * (spectral.x - 1.0 / 3.0),
                                                  1.0 / 3.0 + 1.01 * (spectral.y - 1.0 / 3.0)));
  }
  // Below the line of purples; beyond all light; not a number.
  EXPECT_FALSE(matching().inside_spectral_locus(0.4, 0.08));
  EXPECT_FALSE(matching().inside_spectral_locus(8.09, 0.4));
  EXPECT_FALSE(matching().inside_spectral_locus(std::nan(""), 0.3));
}

}  // namespace
}  // namespace skylut
