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

// Sun at the zenith angle 60° in azimuth 0, view at 40° and 90°: cosΘ = cos 40° cos 60°. Singly scattered
// light is polarised across the plane of scattering by -F12/F11 = Δ sin²Θ/… ; the angle σ between that
// plane's normal and the view's horizontal turns it: Q = F12 cos 2σ, U = -F12 sin 2σ, with the plane's first
// axis (the sun's direction less its part along the view) at σ from the vertical.
TEST(MonteCarlo, FirstOrderPolarisedIsTheClosedForm) {
  const Shells shells{{0.0, 10.0}, 1e6};
  const auto rayleigh = std::make_shared<const RayleighPhaseFunction>(0.03);
  const OpticalColumn column{{0.4}, {{rayleigh, {0.36}}}, 0.0};
  const double view = 40.0 * kRadiansPerDegree;
  const double sun = 60.0 * kRadiansPerDegree;
  for (const double azimuth_deg : {0.0, 90.0, 150.0}) {
    const double azimuth = azimuth_deg * kRadiansPerDegree;
    const auto estimate =
        solve_monte_carlo(test::context, shells, column, {0.0, 60.0, {{40.0, azimuth_deg}}},
                          {.photons = 20'000, .seed = 1, .orders = 1, .polarised = true})[0];
    // The sun's direction along the view's two axes: towards the zenith, and towards increasing azimuth.
    const double up = std::cos(sun) * std::sin(view) - std::sin(sun) * std::cos(view) * std::cos(azimuth);
    const double along = -std::sin(sun) * std::sin(azimuth);
    const double sine_squared = up * up + along * along;
    const ScatteringMatrix matrix =
        rayleigh->matrix(std::cos(sun) * std::cos(view) + std::sin(sun) * std::sin(view) * std::cos(azimuth));
    const double path = 0.9 / (4.0 * kPi) * std::cos(sun) / (std::cos(sun) - std::cos(view)) *
                        (std::exp(-0.4 / std::cos(sun)) - std::exp(-0.4 / std::cos(view)));
    const double tolerance = 1e-4 * path;
    EXPECT_NEAR(estimate.radiance, path * matrix.f11, tolerance) << azimuth_deg;
    EXPECT_NEAR(estimate.stokes_q, path * matrix.f12 * (up * up - along * along) / sine_squared, tolerance)
        << azimuth_deg;
    EXPECT_NEAR(estimate.stokes_u, path * matrix.f12 * 2.0 * up * along / sine_squared, tolerance)
        << azimuth_deg;
  }
}

// Natraj, Li & Yung 2009, doi:10.1088/0004-637X/691/2/1909: Rayleigh, depth 0.5, cos(sun) 0.2, black ground,
// seen from the ground with μ = 0.1 at 90° and 0.52 at 0°; I, Q, U of a beam of flux 1. All orders.
TEST(MonteCarlo, PolarisedPlaneLimitIsThePublishedTable) {
  const Shells shells{{0.0, 1.0}, 1e6};
  const OpticalColumn column{{0.5}, {{std::make_shared<const RayleighPhaseFunction>(), {0.5}}}, 0.0};
  const double sun_deg = std::acos(0.2) * kDegreesPerRadian;
  const double view_deg = std::acos(0.1) * kDegreesPerRadian;
  const auto estimate =
      solve_monte_carlo(test::context, shells, column, {0.0, sun_deg, {{view_deg, 90.0}, {view_deg, 0.0}}},
                        {.photons = 200'000, .seed = 2, .polarised = true});
  const double expected[2][3] = {{0.028014911, 0.018774076, 0.006611917}, {0.042926447, 0.004897042, 0.0}};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(estimate[i].standard_error, 0.005 * expected[i][0]);
    EXPECT_NEAR(estimate[i].radiance, expected[i][0], 4.0 * estimate[i].standard_error);
    EXPECT_NEAR(estimate[i].stokes_q, expected[i][1], 4.0 * estimate[i].stokes_q_error);
    EXPECT_NEAR(estimate[i].stokes_u, expected[i][2], 4.0 * estimate[i].stokes_u_error);
  }
}

// Light that no scatterer polarises is the scalar equation's, draw for draw; so is what a bright ground adds.
TEST(MonteCarlo, UnpolarisingMediumIsTheScalarOne) {
  OpticalColumn column = hazy_column();
  column.scatterers.erase(column.scatterers.begin());
  const MonteCarloRequest request = views_of(2.0, 50.0);
  const auto scalar = solve_monte_carlo(test::context, kEarth, column, request, {.photons = 2'000});
  const auto stokes =
      solve_monte_carlo(test::context, kEarth, column, request, {.photons = 2'000, .polarised = true});
  for (std::size_t i = 0; i < scalar.size(); ++i) {
    EXPECT_NEAR(stokes[i].radiance, scalar[i].radiance, 1e-12 * scalar[i].radiance);
    EXPECT_EQ(stokes[i].stokes_q, 0.0);
    EXPECT_EQ(scalar[i].stokes_u_error, 0.0);
  }
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
