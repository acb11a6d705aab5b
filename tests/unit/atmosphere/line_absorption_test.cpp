#include "skylut/atmosphere/line_absorption.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/errors.hpp"
#include "skylut/profile/profile.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Equivalent width in nm: ∫ (1 - T) dλ, nm by nm.
double equivalent_width_nm(const LineAbsorption& lines, double first_nm, double last_nm, double amount) {
  double width = 0.0;
  for (double nm = first_nm; nm <= last_nm; nm += 1.0)
    width += 1.0 - transmittance(lines.band(nm, 1.0).sum, amount);
  return width;
}

TEST(LineAbsorption, WeightsAddUpToOne) {
  const LineAbsorption water = load_water_lines(test::context);
  const LineAbsorption oxygen = load_oxygen_lines(test::context);
  for (const LineAbsorption* lines : {&water, &oxygen})
    for (double band_nm : {0.3, 1.0, 5.0, 10.0})
      for (double nm = 300.0; nm <= 1000.0; nm += 2.5) {
        const LineBand band = lines->band(nm, band_nm);
        double weights = 0.0;
        for (const Exponential& term : band.sum) {
          EXPECT_GT(term.weight, 0.0);
          EXPECT_GE(term.coefficient, 0.0);
          weights += term.weight;
        }
        EXPECT_NEAR(weights, 1.0, 1e-9) << nm;
        EXPECT_NEAR(transmittance(band.sum, 0.0), 1.0, 1e-9);
      }
}

// A band is the mean of its parts.
TEST(LineAbsorption, BandIsTheMeanOfItsNanometres) {
  const LineAbsorption water = load_water_lines(test::context);
  for (double amount : {1e25, 1e26, 1e27, 1e28}) {
    double mean = 0.0;
    for (double nm : {718.0, 719.0, 720.0, 721.0, 722.0})
      mean += 0.2 * transmittance(water.band(nm, 1.0).sum, amount);
    EXPECT_NEAR(transmittance(water.band(720.0, 5.0).sum, amount), mean, 1e-12);
  }
}

// Curve of growth: a little gas absorbs in proportion, more of it slower. The A band of oxygen at the ground
// is on the square-root part: four times the path doubles its width until neighbouring lines meet (LOWTRAN 7
// has the exponent 0.564 for a single nm).
TEST(LineAbsorption, CurveOfGrowth) {
  const LineAbsorption oxygen = load_oxygen_lines(test::context);
  const auto width = [&](double amount) { return equivalent_width_nm(oxygen, 755.0, 778.0, amount); };
  EXPECT_NEAR(width(2e20) / width(1e20), 2.0, 0.01);
  const double slope = std::log(width(4.5e28) / width(4.5e27)) / std::log(10.0);
  EXPECT_GT(slope, 0.30);
  EXPECT_LT(slope, 0.55);
  const LineAbsorption water = load_water_lines(test::context);
  const auto absorbed = [&](double amount) {
    return 1.0 - transmittance(water.band(645.0, 5.0).sum, amount);
  };
  EXPECT_NEAR(absorbed(2e21) / absorbed(1e21), 2.0, 0.01);
  EXPECT_LT(absorbed(2e26) / absorbed(1e26), 1.8);
}

// The exponents of the band model (Pierluissi et al. 1989), between two regions those of the stronger part.
TEST(LineAbsorption, Exponents) {
  const LineAbsorption water = load_water_lines(test::context);
  EXPECT_NEAR(water.band(720.0, 5.0).pressure_exponent, 0.8088, 1e-12);
  EXPECT_NEAR(water.band(590.0, 5.0).temperature_exponent, 0.5061, 1e-12);
  const LineBand none = water.band(450.0, 5.0);
  ASSERT_EQ(none.sum.size(), 1u);
  EXPECT_EQ(none.sum[0].coefficient, 0.0);
}

// LOWTRAN 7's formula itself at one point: 13700 cm-1 (729.927 nm), C' = 10^-1.52352 (g/cm²)^-1, a = 0.6076.
// Its neighbours over 1 nm span 0.06 in log C', so one point and the mean of the nm differ by a little.
TEST(LineAbsorption, WaterAgainstTheBandModel) {
  const LineAbsorption water = load_water_lines(test::context);
  for (double grams_per_cm2 : {0.1, 1.0, 3.0, 10.0, 50.0}) {
    const double model = std::exp(-std::pow(std::pow(10.0, -1.52352) * grams_per_cm2, 0.6076));
    EXPECT_NEAR(transmittance(water.band(730.0, 1.0).sum, grams_per_cm2 * water_molecules_per_m2_cm()), model,
                0.01)
        << grams_per_cm2;
  }
}

TEST(LineAbsorption, DisorderIsRefused) {
  EXPECT_THROW(LineAbsorption({{700.0, 1.0, 0.0, {}}, {699.0, 1.0, 0.0, {}}}), InputError);
}

}  // namespace
}  // namespace skylut
