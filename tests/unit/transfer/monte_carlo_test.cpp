#include "skylut/transfer/monte_carlo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/plane_parallel.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

const Shells kEarth{{0.0, 2.0, 10.0, 60.0}, 6371.0};

/// Molecules and an absorbing haze over a grey ground.
OpticalColumn hazy_column() {
  return {{0.30, 0.12, 0.06},
          {{std::make_shared<const RayleighPhaseFunction>(), {0.05, 0.10, 0.05}},
           {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.7), {0.22, 0.01, 0.0}}},
          0.3};
}

MonteCarloRequest views_of(double altitude_km, double sun_zenith_deg) {
  return {altitude_km, sun_zenith_deg, {{0.0, 0.0}, {40.0, 60.0}, {75.0, 180.0}, {120.0, 90.0}}};
}

/// Plane layers seen along the same views.
std::vector<double> plane_radiance(const OpticalColumn& column, const MonteCarloRequest& request,
                                   double depth) {
  std::vector<double> radiance;
  for (const RelativeView& view : request.views) {
    PlaneParallelRequest asked;
    asked.cos_sun_zenith = std::cos(request.sun_zenith_deg * kRadiansPerDegree);
    asked.output_depths = {depth};
    asked.directions = {
        {-std::cos(view.zenith_deg * kRadiansPerDegree), view.relative_azimuth_deg * kRadiansPerDegree}};
    radiance.push_back(solve_plane_parallel(column, asked).radiance[0]);
  }
  return radiance;
}

// With a huge planet the shells are planes, and the plane-parallel solver, good to 1e-5, is the judge.
TEST(MonteCarlo, HugePlanetIsPlaneParallel) {
  const Shells shells{kEarth.levels_km, 1e6};
  const OpticalColumn column = hazy_column();
  const MonteCarloRequest request = views_of(2.0, 50.0);
  const auto estimate = solve_monte_carlo(test::context, shells, column, request, {400'000, 3, 0});
  const std::vector<double> expected = plane_radiance(column, request, 0.18);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT(estimate[i].standard_error, 0.005 * expected[i]) << i;
    // Four standard errors, and 1e-4 for what is left of the curvature: path/radius.
    EXPECT_NEAR(estimate[i].radiance, expected[i], 4.0 * estimate[i].standard_error + 1e-4 * expected[i])
        << i;
  }
}

// One layer on a huge planet, first order: I = ω p/4π · μ0/(μ0-μ) (e^{-τ/μ0} - e^{-τ/μ}), black ground.
TEST(MonteCarlo, FirstOrderIsTheClosedForm) {
  const Shells shells{{0.0, 10.0}, 1e6};
  const OpticalColumn column{{0.4}, {{std::make_shared<const RayleighPhaseFunction>(), {0.36}}}, 0.0};
  const auto estimate =
      solve_monte_carlo(test::context, shells, column, {0.0, 60.0, {{0.0, 0.0}}}, {100'000, 1, 1});
  const double expected =
      0.9 * 0.75 * (1.0 + 0.25) / (4.0 * kPi) * 0.5 / (0.5 - 1.0) * (std::exp(-0.4 / 0.5) - std::exp(-0.4));
  // The stratified first collision leaves hardly any noise; the curvature over 10 km leaves 1e-5.
  EXPECT_LT(estimate[0].standard_error, 1e-4 * expected);
  EXPECT_NEAR(estimate[0].radiance, expected, 4.0 * estimate[0].standard_error + 2e-5 * expected);
}

TEST(MonteCarlo, ThreadsAndOtherViewsChangeNothing) {
  const OpticalColumn column = hazy_column();
  const MonteCarloRequest all = views_of(0.0, 85.0);
  const auto one_thread = solve_monte_carlo(test::on_threads(1), kEarth, column, all, {2'000, 7, 0});
  const auto four_threads = solve_monte_carlo(test::on_threads(4), kEarth, column, all, {2'000, 7, 0});
  const auto alone =
      solve_monte_carlo(test::context, kEarth, column, {0.0, 85.0, {all.views[2]}}, {2'000, 7, 0});
  for (std::size_t i = 0; i < all.views.size(); ++i)
    EXPECT_EQ(one_thread[i].radiance, four_threads[i].radiance);
  EXPECT_EQ(one_thread[2].radiance, alone[0].radiance);
  EXPECT_NE(one_thread[0].radiance,
            solve_monte_carlo(test::context, kEarth, column, all, {2'000, 8, 0})[0].radiance);
}

// A sharp Legendre phase function and the same as Henyey-Greenstein are drawn by the same table: the tail of
// the series beyond l = 120 is 0.85^120 = 3e-9.
TEST(MonteCarlo, LegendreSeriesEqualsItsClosedForm) {
  std::vector<double> moments;
  for (int l = 0; l <= 120; ++l) moments.push_back(std::pow(0.85, l));
  const auto column = [](std::shared_ptr<const PhaseFunction> phase) {
    return OpticalColumn{{0.4, 0.1, 0.05}, {{std::move(phase), {0.4, 0.1, 0.05}}}, 0.1};
  };
  const MonteCarloRequest request{0.0, 60.0, {{50.0, 0.0}}};
  const auto closed = solve_monte_carlo(test::context, kEarth,
                                        column(std::make_shared<const HenyeyGreensteinPhaseFunction>(0.85)),
                                        request, {4'000, 5, 0});
  const auto series =
      solve_monte_carlo(test::context, kEarth, column(std::make_shared<const LegendrePhaseFunction>(moments)),
                        request, {4'000, 5, 0});
  EXPECT_NEAR(series[0].radiance / closed[0].radiance, 1.0, 1e-4);
}

TEST(MonteCarlo, ShadowAndAbsorbersAreDark) {
  const OpticalColumn absorber{{0.3, 0.1, 0.1}, {}, 0.0};
  for (const MonteCarloRadiance& dark :
       solve_monte_carlo(test::context, kEarth, absorber, views_of(0.0, 30.0), {}))
    EXPECT_EQ(dark.radiance, 0.0);
  // Sun 30° below the horizon: the shadow reaches R (1/cos 30° - 1) = 986 km at the zenith, above all air.
  const auto night =
      solve_monte_carlo(test::context, kEarth, hazy_column(), {0.0, 120.0, {{0.0, 0.0}}}, {1'000, 1, 1});
  EXPECT_EQ(night[0].radiance, 0.0);
  // Sun 4° below it: lit above R (1/cos 4° - 1) = 15.6 km.
  const auto twilight =
      solve_monte_carlo(test::context, kEarth, hazy_column(), {0.0, 94.0, {{0.0, 0.0}}}, {1'000, 1, 1});
  EXPECT_GT(twilight[0].radiance, 0.0);
}

// Each order adds light, and many orders are all of them.
TEST(MonteCarlo, OrdersAddUp) {
  double before = 0.0;
  for (int orders : {1, 2, 4}) {
    const auto estimate = solve_monte_carlo(test::context, kEarth, hazy_column(), {0.0, 60.0, {{40.0, 90.0}}},
                                            {50'000, 1, orders});
    EXPECT_GT(estimate[0].radiance, before + 3.0 * estimate[0].standard_error);
    before = estimate[0].radiance;
  }
}

TEST(MonteCarlo, RefusesWhatIsOutOfRange) {
  const OpticalColumn column = hazy_column();
  EXPECT_THROW(solve_monte_carlo(test::context, kEarth, column, views_of(-1.0, 30.0), {}), InputError);
  EXPECT_THROW(solve_monte_carlo(test::context, kEarth, column, views_of(61.0, 30.0), {}), InputError);
  EXPECT_THROW(solve_monte_carlo(test::context, kEarth, column, views_of(0.0, 200.0), {}), InputError);
  EXPECT_THROW(solve_monte_carlo(test::context, kEarth, column, views_of(0.0, 30.0), {10, 1, 0}), InputError);
  EXPECT_THROW(
      solve_monte_carlo(test::context, {kEarth.levels_km, INFINITY}, column, views_of(0.0, 30.0), {}),
      InputError);
  EXPECT_THROW(solve_monte_carlo(test::context, {{0.0, 1.0}, 6371.0}, column, views_of(0.0, 30.0), {}),
               InputError);
}

}  // namespace
}  // namespace skylut
