#include "skylut/atmosphere/exponential_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/atmosphere/line_absorption.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

double sum_of_weights(const std::vector<Exponential>& sum) {
  double weight = 0.0;
  for (const Exponential& term : sum) weight += term.weight;
  return weight;
}

TEST(ExponentialSum, Transmittance) {
  const std::vector<Exponential> sum{{0.25, 0.0}, {0.75, 2.0}};
  EXPECT_EQ(transmittance(sum, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(transmittance(sum, 0.5), 0.25 + 0.75 * std::exp(-1.0));
}

// One exponential is found again to a step of the grid (a ratio of 1.3, hence 0.005 in transmittance).
TEST(FitExponentials, OneStaysOne) {
  const std::vector<Exponential> fit = fit_exponentials({{1.0, 0.01}}, 1.0);
  ASSERT_EQ(fit.size(), 1u);
  EXPECT_EQ(fit[0].weight, 1.0);
  EXPECT_NEAR(fit[0].coefficient, 0.01, 1e-12);  // the strongest there is ends the grid
}

TEST(FitExponentials, NothingAbsorbs) {
  EXPECT_EQ(fit_exponentials({{1.0, 0.0}}, 1.0).size(), 1u);
  EXPECT_EQ(fit_exponentials({{1.0, 0.0}}, 1.0)[0].coefficient, 0.0);
  EXPECT_EQ(fit_exponentials({{0.5, 0.0}, {0.5, 3.0}}, 0.0).size(), 1u);
}

// The bands of both gases at the widths people use: weights sum to 1, coefficients are not negative, and
// transmittances keep the promise of the header.
TEST(FitExponentials, EveryBandOfLines) {
  struct Case {
    LineAbsorption lines;
    double vertical_amount;  // molecules/m²: 1.2 g/cm² of water, 2.3e28 of oxygen, scaled
    double first_nm;
  };
  for (const Case& gas : {Case{load_water_lines(test::context), 4e26, 500.0},
                          Case{load_oxygen_lines(test::context), 2.3e28, 620.0}})
    for (double band_nm : {1.0, 5.0, 10.0})
      for (double wavelength_nm = gas.first_nm; wavelength_nm <= 1000.0; wavelength_nm += band_nm) {
        const LineBand band = gas.lines.band(wavelength_nm, band_nm);
        const std::vector<Exponential> fit = fit_exponentials(band.sum, gas.vertical_amount);
        ASSERT_GE(fit.size(), 1u);
        ASSERT_LE(fit.size(), 3u);
        EXPECT_NEAR(sum_of_weights(fit), 1.0, 1e-12);
        for (std::size_t i = 0; i < fit.size(); ++i) {
          EXPECT_GT(fit[i].weight, 0.0);
          EXPECT_GE(fit[i].coefficient, i == 0 ? 0.0 : fit[i - 1].coefficient);
        }
        // As good as three terms, or terms not blacker than 3, can be: below.
        if (fit.size() == 3 || transmittance(band.sum, gas.vertical_amount) < 0.5) continue;
        for (double m : {0.1, 0.5, 1.0, 1.5, 2.0, 4.0, 10.0, 38.0})
          EXPECT_NEAR(transmittance(fit, m * gas.vertical_amount),
                      transmittance(band.sum, m * gas.vertical_amount),
                      (fit.size() == 1 ? 1.0 : 2.0) * 0.0055 * (1.0 + m / 2.0))
              << wavelength_nm << " nm, band " << band_nm << " nm, m = " << m;
      }
}

// Three terms at the strongest bands there are: the A band of oxygen and the ρστ band of water. At air
// mass 1 to 4 they err by less than 0.05 (0.02 in the A band): no term is blacker than 3.
TEST(FitExponentials, StrongestBands) {
  const auto check = [](const LineBand& band, double vertical_amount, double tolerance) {
    const std::vector<Exponential> fit = fit_exponentials(band.sum, vertical_amount);
    EXPECT_EQ(fit.size(), 3u);
    for (double m : {1.0, 1.5, 2.0, 3.0, 4.0})
      EXPECT_NEAR(transmittance(fit, m * vertical_amount), transmittance(band.sum, m * vertical_amount),
                  tolerance)
          << m;
    EXPECT_LE(fit.back().coefficient * vertical_amount, 3.0 * (1.0 + 1e-12));
  };
  check(load_oxygen_lines(test::context).band(760.0, 5.0), 2.3e28, 0.02);
  check(load_water_lines(test::context).band(935.0, 5.0), 4e26, 0.05);
}

TEST(FitExponentials, SameInputSameTerms) {
  const std::vector<Exponential> band = load_water_lines(test::context).band(720.0, 5.0).sum;
  const std::vector<Exponential> first = fit_exponentials(band, 4e26);
  const std::vector<Exponential> second = fit_exponentials(band, 4e26);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].weight, second[i].weight);
    EXPECT_EQ(first[i].coefficient, second[i].coefficient);
  }
}

}  // namespace
}  // namespace skylut
