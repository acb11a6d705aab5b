#include "skylut/transfer/refraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "geometry/ray_trace.hpp"
#include "geometry/slant_depth_grid.hpp"
#include "geometry/sun_refraction.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/transfer/direct_beam.hpp"
#include "skylut/transfer/sky_radiance.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

constexpr double kPlanet_km = 6371.0;
constexpr double kRefractivity = 2.78e-4;
constexpr double kScale_km = 8.5;  // of the refractivity; the extinction's is 8
constexpr double kTop_km = 100.0;

/// Levels as an atmosphere has them, but closer above 50 km, for suns that light no lower air.
Shells exponential_air() {
  Shells shells;
  for (double h = 0.0; h < 7.0; h += 0.25) shells.levels_km.push_back(h);
  for (double h = 7.0; h < 35.0; h += 0.5) shells.levels_km.push_back(h);
  for (double h = 35.0; h < kTop_km; h += 1.0) shells.levels_km.push_back(h);
  shells.levels_km.push_back(kTop_km);
  shells.planet_radius_km = kPlanet_km;
  for (const double h : shells.levels_km)
    shells.refractivity.push_back(kRefractivity * std::exp(-h / kScale_km));
  return shells;
}

/// Vertical depth of exponential air, 1 in all, by layer.
std::vector<double> depths(const Shells& shells) {
  std::vector<double> depth;
  for (std::size_t i = 0; i + 1 < shells.levels_km.size(); ++i)
    depth.push_back(std::exp(-shells.levels_km[i] / 8.0) - std::exp(-shells.levels_km[i + 1] / 8.0));
  return depth;
}

/// A ray from an observer to the top, by the ray equation dψ/ds = -sin ψ (1/r + n'/n) in exponential air,
/// fourth order Runge and Kutta, steps of 10-100 m: neither optical shells nor Bouguer's rule. Its depth is
/// that of layers.
struct Traced {
  double r;
  double turned = 0.0;
  double psi;
  double depth = 0.0;
  double length = 0.0;
  double true_zenith_rad() const { return psi + turned; }
};

Traced traced(double altitude_km, double apparent_deg) {
  static const Shells shells = exponential_air();
  static const std::vector<double> depth = depths(shells);
  const auto extinction = [&](double h) {
    const auto above = std::upper_bound(shells.levels_km.begin() + 1, shells.levels_km.end() - 1, h);
    return depth[static_cast<std::size_t>(above - shells.levels_km.begin()) - 1] / (*above - *(above - 1));
  };
  using State = std::array<double, 4>;  // r, turned, psi, depth
  const auto rates = [&](const State& s) -> State {
    const double n = kRefractivity * std::exp(-(s[0] - kPlanet_km) / kScale_km);
    return {std::cos(s[2]), std::sin(s[2]) / s[0], -std::sin(s[2]) * (1.0 / s[0] - n / kScale_km / (1.0 + n)),
            extinction(s[0] - kPlanet_km)};
  };
  const auto plus = [](const State& a, const State& b, double f) {
    State sum = a;
    for (std::size_t i = 0; i < 4; ++i) sum[i] += f * b[i];
    return sum;
  };
  State s{kPlanet_km + altitude_km, 0.0, apparent_deg * kRadiansPerDegree, 0.0};
  double length = 0.0;
  while (s[0] < kPlanet_km + kTop_km) {
    // Steep rays cross the layers' boundaries fast.
    const double step_km = std::cos(s[2]) > 0.2 ? 0.01 : 0.1;
    const State a = rates(s);
    const State b = rates(plus(s, a, 0.5 * step_km));
    const State c = rates(plus(s, b, 0.5 * step_km));
    const State d = rates(plus(s, c, step_km));
    for (std::size_t i = 0; i < 4; ++i) s[i] += step_km / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
    length += step_km;
  }
  return {s[0], s[1], s[2], s[3], length};
}

double slant_depth(const Shells& shells, const std::vector<double>& factors) {
  const std::vector<double> depth = depths(shells);
  double sum = 0.0;
  for (std::size_t i = 0; i < depth.size(); ++i) sum += depth[i] * factors[i];
  return sum;
}

// From the ground, from a height, and over a beam's lowest point (94 deg at 20 km: 4.4 km above the ground).
TEST(Refraction, AgreesWithARayTrace) {
  const Shells air = exponential_air();
  for (const auto& [altitude_km, apparent_deg] : {std::pair{0.0, 0.0},
                                                  {0.0, 45.0},
                                                  {0.0, 80.0},
                                                  {0.0, 85.0},
                                                  {0.0, 88.0},
                                                  {0.0, 89.0},
                                                  {0.0, 89.5},
                                                  {0.0, 89.99},
                                                  {3.1, 90.0},
                                                  {12.0, 91.0},
                                                  {12.0, 93.0},
                                                  {20.0, 94.0}}) {
    const Traced ray = traced(altitude_km, apparent_deg);
    const double true_deg = ray.true_zenith_rad() * kDegreesPerRadian;
    const double bending_deg = true_deg - apparent_deg;
    EXPECT_NEAR(true_sun_zenith_deg(air, altitude_km, apparent_deg), true_deg, 2e-4 * bending_deg + 1e-9)
        << altitude_km << " " << apparent_deg;
    const ApparentSun sun = apparent_sun(air, altitude_km, true_deg);
    EXPECT_NEAR(sun.zenith_deg, apparent_deg, 2e-4 * bending_deg + 1e-6);
    EXPECT_FALSE(sun.hidden);
    const auto path = beam_path_factors(air, altitude_km, std::max(0.0, true_deg - 1e-6));
    ASSERT_TRUE(path) << altitude_km << " " << apparent_deg;
    EXPECT_NEAR(slant_depth(air, *path) / ray.depth, 1.0, 5e-4) << altitude_km << " " << apparent_deg;
  }
}

// d(cos ψ)/d(cos χ) by two rays.
TEST(Refraction, BeamsSpread) {
  const Shells air = exponential_air();
  for (const auto& [altitude_km, apparent_deg] :
       {std::pair{0.0, 60.0}, {0.0, 85.0}, {0.0, 89.9}, {12.0, 92.0}, {20.0, 93.5}, {60.0, 97.0}}) {
    const double step_deg = 0.01;
    const double from = traced(altitude_km, apparent_deg - step_deg).true_zenith_rad();
    const double to = traced(altitude_km, apparent_deg + step_deg).true_zenith_rad();
    const double apparent = std::cos((apparent_deg - step_deg) * kRadiansPerDegree) -
                            std::cos((apparent_deg + step_deg) * kRadiansPerDegree);
    const double expected = apparent / (std::cos(from) - std::cos(to));
    const double sun_deg = 0.5 * (from + to) * kDegreesPerRadian;
    EXPECT_NEAR(apparent_sun(air, altitude_km, sun_deg).concentration / expected, 1.0, 3e-3)
        << altitude_km << " " << apparent_deg;
  }
}

TEST(Refraction, AngleThereAndBack) {
  const Shells air = exponential_air();
  for (const double altitude : {0.0, 0.3, 12.0, 30.0})
    for (const double apparent : {0.0, 30.0, 85.0, 90.0, 90.2, 92.0, 94.0, 99.0, 120.0}) {
      const double sun = true_sun_zenith_deg(air, altitude, apparent);
      EXPECT_NEAR(apparent_sun(air, altitude, sun).zenith_deg, apparent, 2e-6) << altitude << " " << apparent;
    }
  EXPECT_TRUE(apparent_sun(air, 0.0, 91.0).hidden);
  EXPECT_FALSE(apparent_sun(air, 0.0, last_sun_zenith_deg(air, 0.0) - 1e-6).hidden);
  EXPECT_FALSE(beam_path_factors(air, 0.0, last_sun_zenith_deg(air, 0.0) + 1e-6));
}

// No air: no bending, to the last bits; no refractivity: the straight functions themselves.
TEST(Refraction, OfNothingIsNothing) {
  Shells none = exponential_air();
  for (double& refractivity : none.refractivity) refractivity = 0.0;
  Shells straight = none;
  straight.refractivity.clear();
  for (const double zenith : {0.0, 60.0, 89.0, 92.0}) {
    EXPECT_NEAR(apparent_sun(none, 12.0, zenith).zenith_deg, zenith, 1e-6);
    EXPECT_NEAR(apparent_sun(none, 12.0, zenith).concentration, 1.0, 1e-6);
    EXPECT_EQ(apparent_sun(straight, 12.0, zenith).zenith_deg, zenith);
    const auto bent = beam_path_factors(none, 12.0, zenith);
    const auto direct = beam_path_factors(straight, 12.0, zenith);
    ASSERT_TRUE(bent && direct);
    for (std::size_t layer = 0; layer < bent->size(); ++layer)
      EXPECT_NEAR((*bent)[layer], (*direct)[layer], 1e-5 * (*direct)[layer] + 1e-9);
  }
}

// What the solver interpolates against what is integrated: beams from above and from below.
TEST(Refraction, TablesAgreeWithIntegration) {
  const Shells shells = exponential_air();
  const transfer::RefractiveShells air(shells);
  const transfer::SunRefraction exact(air, transfer::SunRefraction::Bending::integrated);
  const transfer::SunRefraction table(air);
  std::minstd_rand random(7);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 400; ++i) {
    const double altitude = i % 3 == 0 ? 90.0 * uniform(random) : 20.0 * uniform(random);
    const double last = exact.last_sun_rad(altitude);
    const double sun = i % 2 == 0 ? last * uniform(random) : 1.5 + (last - 1.5) * uniform(random);
    const transfer::Sunbeam expected = exact.sunbeam(altitude, std::cos(sun));
    const transfer::Sunbeam found = table.sunbeam(altitude, std::cos(sun));
    EXPECT_NEAR(found.along_sun_km, expected.along_sun_km, 0.02) << altitude << " " << sun;
    EXPECT_NEAR(found.concentration / expected.concentration, 1.0, 0.01) << altitude << " " << sun;
  }
}

// A bent line of sight: length and the angle about the planet's centre.
TEST(Refraction, LinesOfSight) {
  const Shells shells = exponential_air();
  const transfer::RefractiveShells air(shells);
  for (const auto& [altitude_km, apparent_deg] :
       {std::pair{0.0, 0.0}, {0.0, 60.0}, {0.0, 90.0}, {12.0, 93.0}, {20.0, 94.0}}) {
    const transfer::RayTrace line(air, air.layers(), 10.0, altitude_km,
                                  std::cos(apparent_deg * kRadiansPerDegree));
    const Traced ray = traced(altitude_km, apparent_deg);
    EXPECT_FALSE(line.hits_ground);
    const transfer::RayPoint& end = line.points.back();
    EXPECT_EQ(end.altitude_km, kTop_km);
    const double overshoot = (ray.r - kPlanet_km - kTop_km) / std::cos(ray.psi);
    EXPECT_NEAR(end.distance_km / (ray.length - overshoot), 1.0, 1e-4) << altitude_km << " " << apparent_deg;
    const double turned = ray.turned - overshoot * std::sin(ray.psi) / ray.r;
    EXPECT_NEAR(end.turned_rad, turned, 2e-4 * turned + 1e-12) << altitude_km << " " << apparent_deg;
    EXPECT_NEAR(std::acos(end.cos_view), ray.psi, 2e-4) << altitude_km << " " << apparent_deg;
    for (std::size_t i = 1; i < line.points.size(); ++i)
      EXPECT_GT(line.points[i].distance_km, line.points[i - 1].distance_km);
  }
  EXPECT_TRUE(
      transfer::RayTrace(air, air.layers(), 10.0, 12.0, std::cos(95.0 * kRadiansPerDegree)).hits_ground);
}

/// The zenith's first order of scattering, from the rays' side: a parallel beam of impact parameters b,
/// traced each way from its lowest point by the ray equation; where rays b and b + db cross the observer's
/// vertical, a tube of light b db dη has the width dr sin ψ · r sin χ dη. No searching, no shells, no tables.
double traced_zenith(double vertical_depth, double sun_deg) {
  struct Point {
    double r;
    double psi;
    double turned;
    double depth;
  };
  const double sun = sun_deg * kRadiansPerDegree;
  const double beta = vertical_depth / 8.0;  // at the ground; 100 km hold all of it to 4e-6
  double sum = 0.0;
  constexpr double kLowest_km = 0.05;
  for (double lowest = 0.5 * kLowest_km; lowest < 90.0; lowest += kLowest_km) {
    // n r = b at the lowest point.
    const auto impact = [](double h) {
      return (kPlanet_km + h) * (1.0 + kRefractivity * std::exp(-h / kScale_km));
    };
    const double db = impact(lowest + 0.5 * kLowest_km) - impact(lowest - 0.5 * kLowest_km);
    std::vector<Point> path{{kPlanet_km + lowest, 0.5 * kPi, 0.0, 0.0}};
    constexpr double kStep_km = 4.0;
    while (path.back().r < kPlanet_km + kTop_km) {
      const auto rates = [&](const Point& p) -> Point {
        const double h = p.r - kPlanet_km;
        const double n = kRefractivity * std::exp(-h / kScale_km);
        return {std::cos(p.psi), -std::sin(p.psi) * (1.0 / p.r - n / kScale_km / (1.0 + n)),
                std::sin(p.psi) / p.r, beta * std::exp(-h / 8.0)};
      };
      const auto plus = [](const Point& p, const Point& d, double f) -> Point {
        return {p.r + f * d.r, p.psi + f * d.psi, p.turned + f * d.turned, p.depth + f * d.depth};
      };
      const Point& p = path.back();
      const Point a = rates(p);
      const Point b = rates(plus(p, a, 0.5 * kStep_km));
      const Point c = rates(plus(p, b, 0.5 * kStep_km));
      const Point d = rates(plus(p, c, kStep_km));
      Point next = p;
      for (const auto& [rate, weight] : {std::pair{a, 1.0}, {b, 2.0}, {c, 2.0}, {d, 1.0}})
        next = plus(next, rate, weight * kStep_km / 6.0);
      path.push_back(next);
    }
    // Seen from the lowest point the sun's true zenith angle is that of the outgoing ray's end.
    const double turned = sun - (path.back().psi + path.back().turned);
    if (turned < 0.0 || turned > path.back().turned) continue;
    std::size_t i = 1;
    while (path[i].turned < turned) ++i;
    // Three points: the path is a parabola in the angle.
    const std::size_t first = std::min(i - 1, path.size() - 3);
    double r = 0.0;
    double depth = 0.0;
    for (std::size_t k = first; k < first + 3; ++k) {
      double weight = 1.0;
      for (std::size_t m = first; m < first + 3; ++m)
        if (m != k) weight *= (turned - path[m].turned) / (path[k].turned - path[m].turned);
      r += weight * path[k].r;
      depth += weight * path[k].depth;
    }
    const double h = r - kPlanet_km;
    if (h > kTop_km) continue;
    const double psi = std::asin(impact(lowest) / (r * (1.0 + kRefractivity * std::exp(-h / kScale_km))));
    const double beam =
        std::exp(-path.back().depth - depth) * impact(lowest) * db / (r * std::sin(sun) * std::sin(psi));
    sum += beta * std::exp(-h / 8.0) * std::exp(-vertical_depth * (1.0 - std::exp(-h / 8.0))) * beam;
  }
  const double cosine = std::cos(sun);
  return sum * 0.75 * (1.0 + cosine * cosine) / (4.0 * kPi);
}

TEST(Refraction, ZenithInTwilight) {
  const Shells shells = exponential_air();
  OpticalColumn column;
  column.extinction_depth = depths(shells);
  for (double& depth : column.extinction_depth) depth *= 0.1;
  column.scatterers = {{std::make_shared<const RayleighPhaseFunction>(), column.extinction_depth}};
  TransferOptions options;
  options.scattering_orders = 1;
  for (const double sun_deg : {91.5, 93.0, 95.0, 97.0}) {
    const std::vector<Sight> sights{{0.0, sun_deg, {0.0, 0.0}}};
    const double found = solve_sky_radiance(test::context, shells, {&column, 1}, sights, options).at(0, 0);
    EXPECT_NEAR(found / traced_zenith(0.1, sun_deg), 1.0, 5e-3) << sun_deg;
  }
}

TEST(Refraction, WrongShellsAreRefused) {
  Shells shells = exponential_air();
  shells.refractivity.pop_back();
  EXPECT_THROW(apparent_sun(shells, 0.0, 80.0), InputError);
  shells = exponential_air();
  shells.refractivity[3] = -1e-4;
  EXPECT_THROW(apparent_sun(shells, 0.0, 80.0), InputError);
  shells = exponential_air();
  shells.planet_radius_km = 1e5;  // 1e5 km / 8.5 km · 2.78e-4 > 1
  EXPECT_THROW(apparent_sun(shells, 0.0, 80.0), InputError);
}

}  // namespace
}  // namespace skylut
