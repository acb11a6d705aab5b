#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

/// First order of scattering in spherical shells by plain numerical integration in double precision, written
/// for this test alone: vectors, optical depths by summing chords through shells, Gauss-Legendre panels.
class FirstOrder {
 public:
  FirstOrder(const Shells& shells, const OpticalColumn& column) : shells_(shells), column_(column) {}

  double radiance(double observer_km, double sun_zenith_deg, const RelativeView& view) const {
    const double sun = sun_zenith_deg * kRadiansPerDegree;
    const double zenith = view.zenith_deg * kRadiansPerDegree;
    const double azimuth = view.relative_azimuth_deg * kRadiansPerDegree;
    const double r0 = shells_.planet_radius_km + observer_km;
    const double cos_scattering =
        std::cos(zenith) * std::cos(sun) + std::sin(zenith) * std::sin(sun) * std::cos(azimuth);
    const double end = length(r0, std::cos(zenith));
    std::vector<double> cut = crossings(r0, std::cos(zenith), end);
    // The shadow: X·S < 0 and |X|² - (X·S)² < R².
    const auto lit = [&](double d) {
      const double towards = r0 * std::cos(sun) + d * cos_scattering;
      const double square = r0 * r0 + 2.0 * d * r0 * std::cos(zenith) + d * d;
      return towards >= 0.0 ||
             square - towards * towards >= shells_.planet_radius_km * shells_.planet_radius_km;
    };
    constexpr int kProbes = 4000;
    for (int i = 0; i < kProbes; ++i) {
      double a = end * i / kProbes;
      double b = end * (i + 1) / kProbes;
      if (lit(a) == lit(b)) continue;
      const bool before = lit(a);
      for (int halving = 0; halving < 60; ++halving) (lit(0.5 * (a + b)) == before ? a : b) = 0.5 * (a + b);
      cut.push_back(a);
    }
    std::sort(cut.begin(), cut.end());

    const Quadrature rule = gauss_legendre(6, 0.0, 1.0);
    double sum = 0.0;
    double depth_before = 0.0;
    for (std::size_t piece = 0; piece + 1 < cut.size(); ++piece) {
      const double whole = cut[piece + 1] - cut[piece];
      if (whole <= 0.0) continue;
      const std::size_t layer = layer_at(altitude(r0, std::cos(zenith), cut[piece] + 0.5 * whole));
      const double beta = extinction(layer);
      const int panels = 1 + static_cast<int>(whole / 2.0);
      for (int panel = 0; panel < panels && lit(cut[piece] + 0.5 * whole); ++panel)
        for (std::size_t i = 0; i < rule.node.size(); ++i) {
          const double within = whole * (panel + rule.node[i]) / panels;
          const double d = cut[piece] + within;
          const double h = altitude(r0, std::cos(zenith), d);
          const double r = shells_.planet_radius_km + h;
          const double cos_sun = (r0 * std::cos(sun) + d * cos_scattering) / r;
          sum += whole / panels * rule.weight[i] * scattering(layer, cos_scattering) *
                 std::exp(-depth_before - beta * within - depth_to_space(r, cos_sun));
        }
      depth_before += beta * whole;
    }
    return sum / (4.0 * kPi);
  }

 private:
  double altitude(double r0, double cosine, double d) const {
    return std::sqrt(r0 * r0 + 2.0 * d * r0 * cosine + d * d) - shells_.planet_radius_km;
  }
  std::size_t layer_at(double altitude_km) const {
    const auto above =
        std::upper_bound(shells_.levels_km.begin() + 1, shells_.levels_km.end() - 1, altitude_km);
    return static_cast<std::size_t>(above - shells_.levels_km.begin()) - 1;
  }
  double thickness(std::size_t layer) const {
    return shells_.levels_km[layer + 1] - shells_.levels_km[layer];
  }
  double extinction(std::size_t layer) const { return column_.extinction_depth[layer] / thickness(layer); }
  double scattering(std::size_t layer, double cos_angle) const {
    double sum = 0.0;
    for (const Scatterer& one : column_.scatterers)
      sum += one.scattering_depth[layer] / thickness(layer) * one.phase->value(cos_angle);
    return sum;
  }
  /// To the ground, if the ray goes there, or to the top.
  double length(double r0, double cosine) const {
    const double along = r0 * cosine;
    const double p2 = r0 * r0 - along * along;
    const double ground = shells_.planet_radius_km;
    const double top = ground + shells_.levels_km.back();
    if (cosine < 0.0 && p2 < ground * ground) return -along - std::sqrt(ground * ground - p2);
    // At the top itself rounding may lift the point above it.
    return std::max(0.0, std::sqrt(std::max(0.0, top * top - p2)) - along);
  }
  /// Distances at which the ray passes from layer to layer, with both ends.
  std::vector<double> crossings(double r0, double cosine, double end) const {
    std::vector<double> found{0.0, end};
    const double along = r0 * cosine;
    for (const double level : shells_.levels_km) {
      const double r = shells_.planet_radius_km + level;
      const double square = r * r - r0 * r0 + along * along;
      if (square < 0.0) continue;
      for (const double d : {-along - std::sqrt(square), -along + std::sqrt(square)})
        if (d > 0.0 && d < end) found.push_back(d);
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  double depth_to_space(double r, double cosine) const {
    const double end = length(r, cosine);
    const std::vector<double> cut = crossings(r, cosine, end);
    double depth = 0.0;
    for (std::size_t i = 0; i + 1 < cut.size(); ++i)
      depth += (cut[i + 1] - cut[i]) * extinction(layer_at(altitude(r, cosine, 0.5 * (cut[i] + cut[i + 1]))));
    return depth;
  }

  Shells shells_;
  OpticalColumn column_;
};

const SkyRequest kRequest = {{0.0, 3.3, 12.0, 30.0, 100.0},
                             {0.0, 45.0, 75.0, 85.0, 88.0, 89.9, 90.0, 90.1, 92.0, 94.0},
                             {{0.0, 0.0},
                              {60.0, 180.0},
                              {80.0, 0.0},
                              {88.0, 90.0},
                              {90.0, 0.0},
                              {90.0, 150.0},
                              {93.0, 45.0},
                              {100.0, 90.0},
                              {150.0, 10.0},
                              {180.0, 0.0}}};

/// Every radiance within the relative error of its sun, or, in the shadow, below `dark` times the brightest.
void expect_first_order(const Shells& shells, const OpticalColumn& column, int orders,
                        double (*relative)(double sun_zenith_deg), double dark) {
  TransferOptions options;
  options.scattering_orders = orders;
  const SkyRadiance sky = solve_sky_radiance(test::context, shells, std::span(&column, 1), kRequest, options);
  const FirstOrder first_order(shells, column);
  for (std::size_t s = 0; s < kRequest.sun_zeniths_deg.size(); ++s) {
    const double sun = kRequest.sun_zeniths_deg[s];
    const double brightest = first_order.radiance(12.0, sun, {90.0, 0.0});
    for (std::size_t o = 0; o < kRequest.observer_altitudes_km.size(); ++o)
      for (std::size_t v = 0; v < kRequest.views.size(); ++v) {
        const double altitude = kRequest.observer_altitudes_km[o];
        const RelativeView& view = kRequest.views[v];
        if (altitude == 0.0 && view.zenith_deg > 90.0) continue;
        const double expected = first_order.radiance(altitude, sun, view);
        const double ours = sky.at(0, o, s, v);
        EXPECT_NEAR(ours, expected, relative(sun) * expected + dark * brightest)
            << altitude << " km, sun " << sun << ", view " << view.zenith_deg << " "
            << view.relative_azimuth_deg << ": " << 100.0 * (ours / expected - 1.0) << " %";
      }
  }
}

// So little air (vertical depth 1e-6) that light scatters once. Single precision, and the second order: the
// mean radiance of a limb of some 40 air masses, 1e-4 of the first; all of the light in the shadow.
TEST(SingleScattering, ThinAirIsTheFirstOrder) {
  const OpticalColumn column =
      test::column_of({.rayleigh_depth = 5e-7, .haze_depth = 5e-7, .haze_scattering_albedo = 0.9});
  expect_first_order(
      test::earth(), column, 0, [](double) { return 3e-4; }, 1e-4);
}

/// One order through attenuating air: the steps of the line of sight are the only approximation. They follow
/// the sunbeam's depth to 0.1 % while the sun is up; a low sun may take of them what the solver's accuracy
/// allows a direction there.
double allowed_by_steps(double sun_zenith_deg) {
  if (sun_zenith_deg <= 88.0) return 1e-3;
  return sun_zenith_deg <= 90.1 ? 0.01 : sun_zenith_deg <= 92.0 ? 0.02 : 0.04;
}

// Molecules, whose phase function delta-M leaves alone.
TEST(SingleScattering, OneOrderThroughThickAir) {
  const OpticalColumn column = test::column_of({.rayleigh_depth = 0.3, .absorption_depth = 0.1});
  expect_first_order(test::earth(), column, 1, allowed_by_steps, 1e-6);
}

TEST(SingleScattering, SmallPlanet) {
  const OpticalColumn column = test::column_of({.rayleigh_depth = 0.1, .absorption_depth = 0.02});
  expect_first_order({test::kLevels_km, 1000.0}, column, 1, allowed_by_steps, 1e-6);
}

}  // namespace
}  // namespace skylut
