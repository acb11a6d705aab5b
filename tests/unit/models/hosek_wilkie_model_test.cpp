#include "skylut/models/hosek_wilkie_model.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "skylut/core/errors.hpp"
#include "skylut/models/bernstein.hpp"

namespace skylut {
namespace {

TEST(Bernstein, SumsToOneAndEndsAtTheEndPoints) {
  std::array<double, 6> basis{};
  for (const double x : {0.0, 0.13, 0.5, 0.92, 1.0}) {
    bernstein_basis(x, basis);
    EXPECT_NEAR(std::accumulate(basis.begin(), basis.end(), 0.0), 1.0, 1e-15);
    EXPECT_NEAR(basis[2], 10.0 * x * x * std::pow(1.0 - x, 3), 1e-15);
    EXPECT_NEAR(basis[4], 5.0 * std::pow(x, 4) * (1.0 - x), 1e-15);
  }
  bernstein_basis(0.0, basis);
  EXPECT_EQ(basis[0], 1.0);
  bernstein_basis(1.0, basis);
  EXPECT_EQ(basis[5], 1.0);
}

TEST(HosekWilkie, FormulaByHand) {
  // cosθ = 0.49, γ = 0: 1 + A e^{B/0.5}, and C + D + F + 2G/(1-H)³ + 0.7 I.
  const HosekWilkieCoefficients c{2.0, -0.5, 0.1, 0.2, -3.0, 0.3, 0.04, 0.5, 0.6};
  EXPECT_NEAR(hosek_wilkie(c, 0.49, 0.0, 1.0),
              (1.0 + 2.0 * std::exp(-1.0)) * (0.1 + 0.2 + 0.3 + 0.04 * 2.0 / 0.125 + 0.6 * 0.7), 1e-14);
  // N5 of the sources: 2000 for g = 0.9 at the sun, not 200.
  EXPECT_NEAR(anisotropic_term(0.9, 1.0), 2000.0, 1e-9);
  // The horizon is as at 90°, below it too.
  EXPECT_EQ(hosek_wilkie(c, -0.1, 1.0, std::cos(1.0)), hosek_wilkie(c, 0.0, 1.0, std::cos(1.0)));
}

TEST(HosekWilkie, CurvesAreAlongTheCubeRootOfElevation) {
  EXPECT_EQ(hosek_wilkie_curve_parameter(90.0), 0.0);
  EXPECT_EQ(hosek_wilkie_curve_parameter(0.0), 1.0);
  EXPECT_NEAR(hosek_wilkie_curve_parameter(90.0 - 90.0 / 8.0), 0.5, 1e-15);
}

// An even sky (F = 1) of these expected radiances.
HosekWilkieCurves even(double at_horizon, double at_zenith) {
  HosekWilkieCurves curves;
  curves.coefficients[1].fill(-1.0);
  curves.coefficients[2].fill(1.0);
  curves.mean = {at_horizon, 1.0, 2.0, 3.0, 4.0, at_zenith};
  return curves;
}

HosekWilkieModel model_of_even_skies() {
  HosekWilkieGrid grid{.altitudes_km = {0.0, 10.0},
                       .turbidities = {0.1, 0.3},
                       .albedos = {0.0, 1.0},
                       .channels = {.kind = SkyChannels::Kind::Xyz},
                       .curves = {}};
  for (const double altitude : {1.0, 0.01})
    for (const double turbidity : {1.0, 3.0})
      for (const double albedo : {10.0, 14.0})
        for (int channel = 0; channel < 3; ++channel)
          grid.curves.push_back(even(altitude * turbidity * albedo, 2.0 * altitude * turbidity * albedo));
  ModelInfo info;
  info.name = "even";
  info.altitude_km = {0.0, 10.0, "km"};
  info.turbidity = {0.1, 0.3, ""};
  info.albedo = Range{0.0, 1.0, ""};
  info.sun_zenith_deg = {0.0, 90.0, "deg"};
  info.view_zenith_deg = {0.0, 90.0, "deg"};
  return {info, grid};
}

double luminance(const SkyModel& model, double altitude_km, double turbidity, double albedo, double sun_deg) {
  const SkyConditions conditions{altitude_km, {TurbidityKind::aod500, turbidity}, albedo, {sun_deg, 0.0}};
  return model.at(conditions)->colour(Direction{50.0, 70.0}).Y;
}

TEST(HosekWilkie, EndsOfTheCurvesAreTheirEndPoints) {
  const HosekWilkieModel model = model_of_even_skies();
  EXPECT_NEAR(luminance(model, 0.0, 0.1, 0.0, 90.0), 10.0, 1e-12);
  EXPECT_NEAR(luminance(model, 0.0, 0.1, 0.0, 0.0), 20.0, 1e-12);
}

TEST(HosekWilkie, BlendsValuesLinearlyInLoadAndGroundAndLogarithmsInAltitude) {
  const HosekWilkieModel model = model_of_even_skies();
  EXPECT_NEAR(luminance(model, 0.0, 0.15, 0.0, 90.0), 15.0, 1e-12);
  EXPECT_NEAR(luminance(model, 0.0, 0.1, 0.25, 90.0), 11.0, 1e-12);
  EXPECT_NEAR(luminance(model, 5.0, 0.1, 0.0, 90.0), 1.0, 1e-12);
}

TEST(HosekWilkie, RefusesWhatLiesOutside) {
  const HosekWilkieModel model = model_of_even_skies();
  EXPECT_THROW(luminance(model, 0.0, 0.05, 0.0, 90.0), InputError);
  EXPECT_THROW(luminance(model, 0.0, 0.1, 0.0, 91.0), InputError);
  const SkyConditions conditions{
      .turbidity = {TurbidityKind::aod500, 0.1}, .albedo = 0.0, .sun = {30.0, 0.0}};
  const auto sky = model.at(conditions);
  EXPECT_THROW(sky->colour(Direction{90.5, 0.0}), InputError);
  EXPECT_EQ(sky->wavelengths(), nullptr);
}

}  // namespace
}  // namespace skylut
