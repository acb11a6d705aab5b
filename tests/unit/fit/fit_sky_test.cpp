#include "skylut/fit/fit_sky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/models/preetham_coefficients.hpp"

namespace skylut {
namespace {

std::vector<Yxy> preetham_like_sky(const std::vector<Direction>& views, const Direction& sun) {
  const PerezYxy k = preetham1999_coefficients(2.5);
  std::vector<Yxy> sky;
  for (const Direction& view : views)
    sky.push_back(perez_sky(k.Y, k.x, k.y, {4000.0, 0.25, 0.26}, view.zenith_deg * kRadiansPerDegree,
                            angle_between(view, sun), sun.zenith_deg * kRadiansPerDegree));
  return sky;
}

TEST(FitSky, AllThreeChannels) {
  const auto views = directions_utm271();
  const Direction sun{45.0, 90.0};
  const auto sky = preetham_like_sky(views, sun);
  const PerezYxy k = preetham1999_coefficients(2.5);
  for (const SampleWeights weights : {SampleWeights::uniform, SampleWeights::solid_angle}) {
    SkyFitOptions options;
    options.weights = weights;
    const SkyFit fit = fit_sky(views, sky, sun, options);
    EXPECT_EQ(fit.zenith, sky[0]);
    // As in fit_perez_test: rounding times the condition of the problem.
    EXPECT_NEAR(fit.Y.coefficients.C, k.Y.C, 1e-6);
    EXPECT_NEAR(fit.x.coefficients.A, k.x.A, 1e-6);
    EXPECT_NEAR(fit.y.coefficients.D, k.y.D, 1e-6);
    EXPECT_NEAR(fit.Y.zenith_value, 4000.0, 1e-9);
  }
}

// Weights add up to the number of directions, and are in proportion to the bands around the rings.
TEST(FitSky, SolidAngleWeights) {
  std::vector<double> zenith;
  for (const Direction& view : directions_utm271()) zenith.push_back(view.zenith_deg * kRadiansPerDegree);
  const auto weights = solid_angle_weights(zenith);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 271.0, 1e-10);
  EXPECT_NEAR(weights[0] / 271.0, 1.0 - std::cos(5.0 * kRadiansPerDegree), 1e-9);
  EXPECT_NEAR(30.0 * weights[1] / 271.0,
              std::cos(5.0 * kRadiansPerDegree) - std::cos(15.0 * kRadiansPerDegree), 1e-9);
  EXPECT_NEAR(30.0 * weights[270] / 271.0, std::cos(85.0 * kRadiansPerDegree), 1e-9);
}

TEST(FitSky, NamesTheChannelsThatDidNotConverge) {
  SkyFit fit;
  fit.Y.termination = Termination::converged;
  fit.x.termination = Termination::no_convergence;
  fit.y.termination = Termination::no_convergence;
  EXPECT_EQ(unconverged_channels(fit), "x, y");
  fit.x.termination = fit.y.termination = Termination::converged;
  EXPECT_EQ(unconverged_channels(fit), "");
}

TEST(FitSky, SaysWhatIsWrong) {
  const auto views = directions_utm271();
  const Direction sun{45.0, 90.0};
  auto sky = preetham_like_sky(views, sun);
  const auto message = [&](const std::vector<Direction>& directions, const std::vector<Yxy>& colours) {
    try {
      fit_sky(directions, colours, sun);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message({views.begin() + 1, views.end()}, {sky.begin() + 1, sky.end()}),
            "sky without a zenith direction: one of the 270 directions must have zenith angle 0");
  EXPECT_EQ(message(views, {sky.begin(), sky.begin() + 5}),
            "sky of 271 directions and 5 colours: there must be as many of both");
  EXPECT_EQ(message({views.begin(), views.begin() + 4}, {sky.begin(), sky.begin() + 4}),
            "4 different sky directions: five coefficients need at least 6");
  sky[7].Y = -1.0;
  EXPECT_EQ(message(views, sky), "sky direction 7: Y = -1: must be a number greater than 0");
  sky[7] = {1.0, std::numeric_limits<double>::quiet_NaN(), 0.3};
  EXPECT_EQ(message(views, sky), "sky direction 7: x = nan, y = 0.3: must be finite numbers");
}

}  // namespace
}  // namespace skylut
