#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/transfer/plane_parallel.hpp"

namespace skylut {
namespace {

const std::vector<RelativeView> kViews = {{0.0, 0.0},     {30.0, 0.0},  {30.0, 120.0}, {60.0, 60.0},
                                          {80.0, 180.0},  {85.0, 30.0}, {95.0, 90.0},  {110.0, 0.0},
                                          {140.0, 150.0}, {180.0, 0.0}};
const std::vector<double> kSuns_deg = {0.0, 45.0, 65.0, 80.0};
const std::vector<double> kObservers_km = {0.0, 3.0, 12.0, 100.0};

/// Optical depth above a level of test::kLevels_km.
double depth_above(const OpticalColumn& column, double altitude_km) {
  double depth = 0.0;
  for (std::size_t layer = column.extinction_depth.size();
       layer-- > 0 && test::kLevels_km[layer] >= altitude_km;)
    depth += column.extinction_depth[layer];
  return depth;
}

/// Compares with the plane-parallel solver, which is good to 1e-5 (its own tests).
/// @param relative  of I, also for Q and U where light is polarised
void expect_plane(const OpticalColumn& column, double relative, bool polarised = true) {
  TransferOptions options;
  options.stokes = polarised;
  if (!polarised) options.discretisation.polarised_degree = 0;
  const SkyRadiance sky = solve_sky_radiance(test::context, test::huge_planet(), {&column, 1},
                                             {kObservers_km, kSuns_deg, kViews}, options);
  double worst = 0.0;
  double sum = 0.0;
  int count = 0;
  PlaneParallelRequest asked;
  asked.polarised = polarised;
  for (const double observer_km : kObservers_km)
    asked.output_depths.push_back(depth_above(column, observer_km));
  for (const RelativeView& view : kViews)
    asked.directions.push_back(
        {-std::cos(view.zenith_deg * kRadiansPerDegree), view.relative_azimuth_deg * kRadiansPerDegree});
  for (std::size_t s = 0; s < kSuns_deg.size(); ++s) {
    asked.cos_sun_zenith = std::cos(kSuns_deg[s] * kRadiansPerDegree);
    const PlaneParallelResult plane = solve_plane_parallel(column, asked);
    for (std::size_t o = 0; o < kObservers_km.size(); ++o)
      for (std::size_t v = 0; v < kViews.size(); ++v) {
        if (kObservers_km[o] == 0.0 && kViews[v].zenith_deg > 90.0) continue;
        if (kObservers_km[o] == 100.0 && kViews[v].zenith_deg < 90.0) continue;
        SCOPED_TRACE(testing::Message() << kObservers_km[o] << " km, sun " << kSuns_deg[s] << ", view "
                                        << kViews[v].zenith_deg << " " << kViews[v].relative_azimuth_deg);
        const std::size_t at = o * kViews.size() + v;
        const double expected = plane.radiance[at];
        const double error = sky.at(0, o, s, v) / expected - 1.0;
        EXPECT_NEAR(error, 0.0, relative);
        if (polarised) {
          const std::size_t sight = (o * kSuns_deg.size() + s) * kViews.size() + v;
          EXPECT_NEAR(sky.stokes_q(0, sight), plane.stokes_q[at], relative * expected);
          EXPECT_NEAR(sky.stokes_u(0, sight), plane.stokes_u[at], relative * expected);
        }
        worst = std::max(worst, std::abs(error));
        sum += error * error;
        ++count;
      }
  }
  testing::Test::RecordProperty("worst_percent", std::to_string(100.0 * worst));
  testing::Test::RecordProperty("rms_percent", std::to_string(100.0 * std::sqrt(sum / count)));
}

// A water cloud's depth in one layer, over a black and a bright ground, seen from below and from above:
// within 0.7 % at a depth of 64, conservative or not (1 % is promised). The stop keeps its promise: its
// changes are a hundred times smaller than what is left where nothing corrects them.
TEST(PlaneLimit, Clouds) {
  const Shells shells{{0.0, 1.0, 2.0, 20.0}, 6.4e7};
  const auto droplets = std::make_shared<const HenyeyGreensteinPhaseFunction>(0.85);
  const auto molecules = std::make_shared<const RayleighPhaseFunction>();
  struct Cloud {
    double depth;
    double scattering_albedo;
    double ground_albedo;
  };
  for (const auto& [depth, scattering_albedo, ground_albedo] :
       {Cloud{64.0, 1.0, 0.8}, Cloud{64.0, 0.99, 0.0}}) {
    const OpticalColumn column{
        {0.02, depth, 0.1},
        {{molecules, {0.02, 0.0, 0.1}}, {droplets, {0.0, scattering_albedo * depth, 0.0}}},
        ground_albedo};
    const SkyRadiance sky = test::solve(
        shells, column, {{0.0, 20.0}, {30.0}, {{0.0, 0.0}, {60.0, 120.0}, {180.0, 0.0}, {120.0, 60.0}}});
    PlaneParallelRequest asked;
    asked.cos_sun_zenith = std::cos(30.0 * kRadiansPerDegree);
    asked.output_depths = {depth + 0.12};
    asked.directions = {{-1.0, 0.0}, {-0.5, 120.0 * kRadiansPerDegree}};
    const auto from_below = solve_plane_parallel(column, asked).radiance;
    asked.output_depths = {0.0};
    asked.directions = {{1.0, 0.0}, {0.5, 60.0 * kRadiansPerDegree}};
    const auto from_above = solve_plane_parallel(column, asked).radiance;
    for (std::size_t v = 0; v < 2; ++v) {
      EXPECT_NEAR(sky.at(0, 0, 0, v) / from_below[v], 1.0, 1e-2) << depth << " " << scattering_albedo << v;
      EXPECT_NEAR(sky.at(0, 1, 0, v + 2) / from_above[v], 1.0, 1e-2)
          << depth << " " << scattering_albedo << v;
    }
  }
}

// One layer of 120 km is the same medium as 120 of 1 km, to the last twilight.
TEST(PlaneLimit, OneThickLayerIsManyThinOnes) {
  const auto molecules = std::make_shared<const RayleighPhaseFunction>();
  const Shells one{{0.0, 120.0}, 6371.0};
  Shells many{{0.0}, 6371.0};
  OpticalColumn thin{{}, {{molecules, {}}}, 0.2};
  for (int level = 1; level <= 120; ++level) {
    many.levels_km.push_back(level);
    thin.extinction_depth.push_back(0.3 / 120.0);
    thin.scatterers[0].scattering_depth.push_back(0.3 / 120.0);
  }
  const SkyRequest request{{0.0}, {60.0, 90.0, 96.0}, {{0.0, 0.0}, {60.0, 180.0}, {88.0, 90.0}}};
  const SkyRadiance thick = test::solve(one, {{0.3}, {{molecules, {0.3}}}, 0.2}, request);
  const SkyRadiance fine = test::solve(many, thin, request);
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t v = 0; v < 3; ++v)
      EXPECT_NEAR(thick.at(0, 0, s, v) / fine.at(0, 0, s, v), 1.0, 3e-3) << s << v;
}

// Discretisation at default quality: 0.1 % for a Rayleigh sky (0.12 % under an overhead sun at 400 nm), 0.3 %
// with a forward peak (the cut-off share
// of the peak is up to 1.5 % of the scattering).
TEST(PlaneLimit, Rayleigh) {
  expect_plane(test::column_of({.rayleigh_depth = 0.1, .ground_albedo = 0.0}), 1e-3);
}
TEST(PlaneLimit, BlueRayleighOverSnow) {
  expect_plane(test::column_of({.rayleigh_depth = 0.4, .absorption_depth = 0.05, .ground_albedo = 0.9}),
               1.5e-3);
}
TEST(PlaneLimit, UnpolarisedHaze) {
  expect_plane(
      test::column_of(
          {.rayleigh_depth = 0.1, .haze_depth = 0.3, .haze_scattering_albedo = 0.93, .ground_albedo = 0.2}),
      3e-3, false);
}
TEST(PlaneLimit, ThickHaze) {
  expect_plane(
      test::column_of(
          {.rayleigh_depth = 0.1, .haze_depth = 1.0, .haze_scattering_albedo = 0.95, .ground_albedo = 0.1}),
      3e-3);
}

/// A haze that polarises half as much as dipoles do: F12/F11, and F33/F11, of Rayleigh's law.
class PolarisingHaze final : public PhaseFunction {
 public:
  double value(double mu) const override { return shape_.value(mu); }
  double moment(int l) const override { return shape_.moment(l); }
  ScatteringMatrix matrix(double mu) const override {
    const double f11 = value(mu);
    const double square = mu * mu;
    return {f11, -0.5 * f11 * (1.0 - square) / (1.0 + square), f11, f11 * 2.0 * mu / (1.0 + square)};
  }

 private:
  HenyeyGreensteinPhaseFunction shape_{0.65};
};

TEST(PlaneLimit, HazeThatPolarises) {
  OpticalColumn column = test::column_of(
      {.rayleigh_depth = 0.1, .haze_depth = 0.3, .haze_scattering_albedo = 0.93, .ground_albedo = 0.2});
  column.scatterers.back().phase = std::make_shared<const PolarisingHaze>();
  expect_plane(column, 3e-3);
}

// Around the sun, light is scattered more than once within the forward peak that delta-M takes for none. A
// haze whose particles diffract (a narrow peak on a broad phase function) is within 0.7 % of the
// plane-parallel solver with 192 streams, which resolves the peak; without ForwardPeakCorrection the sky is 5
// % too bright at 1 degree and 1.5 % at 3.
TEST(PlaneLimit, AureoleOfAPeakedPhaseFunction) {
  const Shells shells{{0.0, 2.0, 100.0}, 6.4e7};
  const OpticalColumn column{{0.5, 0.1},
                             {{std::make_shared<const RayleighPhaseFunction>(), {0.05, 0.05}},
                              {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.97), {0.1, 0.005}},
                              {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.6), {0.3, 0.02}}},
                             0.1};
  constexpr double kSun_deg = 45.0;
  SkyRequest request{{0.0}, {kSun_deg}, {}};
  for (const double off_deg : {1.0, 2.0, 3.0, 5.0, 8.0, 11.0, 15.0})
    for (const double side : {-1.0, 1.0}) request.views.push_back({kSun_deg + side * off_deg, 0.0});
  const SkyRadiance sky = test::solve(shells, column, request);
  PlaneParallelRequest asked;
  asked.cos_sun_zenith = std::cos(kSun_deg * kRadiansPerDegree);
  asked.output_depths = {0.6};
  asked.streams = 192;
  for (const RelativeView& view : request.views)
    asked.directions.push_back({-std::cos(view.zenith_deg * kRadiansPerDegree), 0.0});
  const PlaneParallelResult expected = solve_plane_parallel(column, asked);
  for (std::size_t v = 0; v < request.views.size(); ++v)
    EXPECT_NEAR(sky.at(0, 0, 0, v) / expected.radiance[v], 1.0, 7e-3)
        << request.views[v].zenith_deg - kSun_deg;
}

// Reflection function of plane air: I(μ0 → μ, φ)/μ0 is symmetric in μ0 and μ (van de Hulst 1980, §3.1). The
// solver treats sun and view in entirely different ways.
TEST(PlaneLimit, ReflectionIsReciprocal) {
  const double angles_deg[] = {0.0, 25.0, 50.0, 70.0, 80.0};
  for (const test::Air& air :
       {test::Air{.rayleigh_depth = 0.3, .ground_albedo = 0.2},
        test::Air{
            .rayleigh_depth = 0.1, .haze_depth = 0.5, .haze_scattering_albedo = 0.9, .ground_albedo = 0.1},
        test::Air{.rayleigh_depth = 0.05, .haze_depth = 2.0, .haze_asymmetry = 0.8}}) {
    SkyRequest request{{100.0}, {}, {}};
    for (const double angle : angles_deg) {
      request.sun_zeniths_deg.push_back(angle);
      request.views.push_back({180.0 - angle, 60.0});
    }
    const SkyRadiance sky = test::solve(test::huge_planet(), test::column_of(air), request);
    const auto reflection = [&](std::size_t sun, std::size_t view) {
      return sky.at(0, 0, sun, view) / std::cos(angles_deg[sun] * kRadiansPerDegree);
    };
    for (std::size_t a = 0; a < std::size(angles_deg); ++a)
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_NEAR(reflection(a, b) / reflection(b, a), 1.0, 3e-3)
            << air.haze_depth << ": " << angles_deg[a] << " " << angles_deg[b];
  }
}

}  // namespace
}  // namespace skylut
