#include "skylut/table/table_sky.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "skylut/colour/cie1931.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/sky/simulate_sky.hpp"
#include "skylut/table/fit_table.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

SkyScene scene(std::vector<double> altitudes_km, std::vector<double> aod500, std::vector<Direction> suns) {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = std::move(altitudes_km);
  for (const double load : aod500) scene.turbidities.push_back({TurbidityKind::aod500, load});
  scene.suns = std::move(suns);
  scene.wavelengths = WavelengthGrid(400.0, 700.0, 50.0);
  return scene;
}

TransferOptions draft() {
  TransferOptions options;
  options.discretisation = discretisation_of(Quality::draft);
  return options;
}

// Line of sight by line of sight the colours are those of simulate_sky, in whatever order directions, loads
// and suns come.
TEST(TableSky, SeesWhatSimulateSkySees) {
  SkyScene asked = scene({0.0, 12.0}, {0.0, 0.3}, {{60.0, 90.0}, {60.0, 270.0}, {20.0, 0.0}});
  TableSampling sampling;
  sampling.map_directions = directions_utm271();
  sampling.exact = true;
  const TableSkies table = simulate_table_skies(test::context, asked, {}, sampling);
  asked.directions = directions_utm271();
  const std::vector<SkyMap> maps = simulate_sky(test::context, asked, {});
  ASSERT_EQ(table.maps.size(), maps.size());
  ASSERT_EQ(table.skies.size(), maps.size());
  for (std::size_t row = 0; row < maps.size(); ++row) {
    EXPECT_EQ(table.skies[row].altitude_km, maps[row].altitude_km);
    EXPECT_EQ(table.skies[row].turbidity.value, maps[row].turbidity.value);
    EXPECT_EQ(table.skies[row].sun, maps[row].sun);
    EXPECT_EQ(table.maps[row].directions, maps[row].directions);
    for (std::size_t i = 0; i < maps[row].colour.size(); ++i)  // summed in single precision
      EXPECT_NEAR(table.maps[row].colour[i].Y / maps[row].colour[i].Y, 1.0, 2e-6);
    EXPECT_NEAR(table.skies[row].fitted.colour[0].Y / maps[row].colour[0].Y, 1.0, 2e-6);
  }
  // East and west look the same from under their suns, to the last bit.
  EXPECT_EQ(table.skies[0].fitted.colour, table.skies[1].fitted.colour);
}

// Root mean square of the relative differences of luminance.
double apart(const SampledSky& a, const SampledSky& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) sum += std::pow(a.colour[i].Y / b.colour[i].Y - 1.0, 2.0);
  return std::sqrt(sum / static_cast<double>(a.colour.size()));
}

// What is interpolated among lines of sight is no further from them than 0.1 %, a tenth of what a formula can
// follow, and sees the same directions and the same light below 90°.
TEST(TableSky, SmoothDomesAreTheirLinesOfSight) {
  const SkyScene asked = scene({0.0, 12.0}, {0.3}, {{60.0, 90.0}, {90.0, 0.0}});
  TransferOptions all_suns = draft();
  all_suns.discretisation.sun_bands = false;
  TableSampling lines;
  lines.exact = true;
  const TableSkies exact = simulate_table_skies(test::context, asked, all_suns, lines);
  const TableSkies smooth = simulate_table_skies(test::context, asked, draft(), {});
  for (std::size_t row = 0; row < exact.skies.size(); ++row) {
    EXPECT_EQ(smooth.skies[row].fitted.views, exact.skies[row].fitted.views);
    EXPECT_EQ(smooth.skies[row].check.views, exact.skies[row].check.views);
    EXPECT_LT(apart(smooth.skies[row].fitted, exact.skies[row].fitted), 1e-3) << row;
    EXPECT_LT(apart(smooth.skies[row].check, exact.skies[row].check), 1e-3) << row;
    EXPECT_EQ(smooth.skies[row].Y_below_cd_m2, exact.skies[row].Y_below_cd_m2);
  }
}

TEST(TableSky, GivenDirectionsAreSeenFromTheSun) {
  TableSampling sampling;
  sampling.directions = directions_utm271();
  const SkyScene asked = scene({0.0}, {0.3}, {{60.0, 90.0}, {60.0, 270.0}});
  const TableSkies table = simulate_table_skies(test::context, asked, {}, sampling);
  EXPECT_EQ(table.skies[0].fitted.views.size(), 271u);
  EXPECT_EQ(table.skies[0].fitted.views, table.skies[1].fitted.views);
  EXPECT_TRUE(table.skies[0].fitted.solid_angles_sr.empty());
}

// From the ground nothing lies between 90° and the horizon; from 12 km a band of 3.5° (acos(R/(R + h))),
// which from 30 km is brighter than anything above it.
TEST(TableSky, LightBelow90) {
  const TableSkies table =
      simulate_table_skies(test::context, scene({0.0, 12.0, 30.0}, {0.1}, {{45.0, 0.0}}), {}, {});
  EXPECT_EQ(table.skies[0].Y_below_cd_m2, 0.0);
  EXPECT_EQ(table.skies[0].light_below, 0.0);
  EXPECT_NEAR(table.skies[1].geometric_horizon_deg - 90.0, std::acos(6371.0 / 6383.0) * kDegreesPerRadian,
              0.01);
  const TableSky& high = table.skies[2];
  double brightest = 0.0;
  for (const Yxy& colour : high.check.colour) brightest = std::max(brightest, colour.Y);
  EXPECT_GT(high.Y_below_cd_m2, 2.0 * brightest);
  // Of all light: the band's solid angle, 2π sin 5.6°, times its mean, against the dome's.
  double above = 0.0;
  for (std::size_t i = 0; i < high.check.colour.size(); ++i)
    above += high.check.solid_angles_sr[i] * high.check.colour[i].Y;
  const double below =
      2.0 * kPi * std::sin((high.geometric_horizon_deg - 90.0) * kRadiansPerDegree) * high.Y_below_cd_m2;
  EXPECT_NEAR(high.light_below, below / (above + below), 1e-9);
}

TEST(TableSky, ToTheHorizonItSeesAllOfIt) {
  TableSampling sampling;
  sampling.to_horizon = true;
  const TableSkies table =
      simulate_table_skies(test::context, scene({0.0, 30.0}, {0.1}, {{45.0, 0.0}}), {}, sampling);
  EXPECT_EQ(table.skies[0].dome_ends_deg, 90.0);
  const TableSky& high = table.skies[1];
  EXPECT_EQ(high.dome_ends_deg, high.geometric_horizon_deg);
  EXPECT_NEAR(high.fitted.views.back().zenith_deg, high.dome_ends_deg, 1e-9);
  EXPECT_GT(high.light_below, 0.1);
}

using Formula = std::function<double(const Direction& view)>;

Formula formula(const PerezCoefficients& k, double zenith, const Direction& sun) {
  return [=](const Direction& view) {
    return zenith * perez_relative(k, view.zenith_deg * kRadiansPerDegree, angle_between(view, sun),
                                   sun.zenith_deg * kRadiansPerDegree);
  };
}

// How many directions of a fine dome no light can have.
int impossible(const ColourMatching& colours, const Formula& Y, const Formula& x, const Formula& y) {
  int count = 0;
  for (double zenith = 0.0; zenith <= 90.0; zenith += zenith < 88.0 ? 2.0 : 0.1)
    for (double azimuth = 0.0; azimuth <= 180.0; azimuth += azimuth < 10.0 ? 0.5 : 10.0) {
      const Direction view{std::min(zenith, 90.0), azimuth};
      if (!(Y(view) > 0.0) || !colours.inside_spectral_locus(x(view), y(view))) ++count;
    }
  return count;
}

PerezCoefficients half(const PerezCoefficients& a, const PerezCoefficients& b) {
  return {0.5 * (a.A + b.A), 0.5 * (a.B + b.B), 0.5 * (a.C + b.C), 0.5 * (a.D + b.D), 0.5 * (a.E + b.E)};
}

// Rows, and halves of neighbours, are skies; coefficients fit half floats. The suns are those of the report
// and one close to the horizon.
TEST(TableSky, RowsAndTheirHalvesAreSkies) {
  const std::vector<double> altitudes{0.0, 6.0, 12.0};
  const std::vector<double> loads{0.0, 0.5};
  const std::vector<Direction> suns{{0.0, 0.0}, {45.0, 0.0}, {87.0, 0.0}, {90.0, 0.0}};
  const TableSkies skies = simulate_table_skies(test::context, scene(altitudes, loads, suns), draft(), {});
  const SkyTable table = fit_table(test::context, skies.skies, TableFitOptions::half_floats());
  EXPECT_NO_THROW(require_converged(table));
  const ColourMatching colours = ColourMatching::load(test::context);
  const std::size_t strides[] = {loads.size() * suns.size(), suns.size(), 1};
  const std::size_t sizes[] = {altitudes.size(), loads.size(), suns.size()};
  for (std::size_t row = 0; row < table.entries.size(); ++row) {
    const TableEntry& one = table.entries[row];
    for (const PerezCoefficients* k : {&one.Y, &one.x, &one.y}) {
      for (const double value : k->values()) EXPECT_LT(std::abs(value), 6e4) << "row " << row + 1;
      EXPECT_GT(std::exp(k->B), 6.1e-5);  // a normal half float
    }
    EXPECT_EQ(impossible(colours, formula(one.Y, one.zenith.Y, one.sun),
                         formula(one.x, one.zenith.x, one.sun), formula(one.y, one.zenith.y, one.sun)),
              0)
        << "row " << row + 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (row / strides[axis] % sizes[axis] + 1 == sizes[axis]) continue;
      const TableEntry& other = table.entries[row + strides[axis]];
      const Direction sun{0.5 * (one.sun.zenith_deg + other.sun.zenith_deg), 0.0};
      EXPECT_EQ(impossible(colours, formula(half(one.Y, other.Y), 1.0, sun),
                           formula(half(one.x, other.x), 0.5 * (one.zenith.x + other.zenith.x), sun),
                           formula(half(one.y, other.y), 0.5 * (one.zenith.y + other.zenith.y), sun)),
                0)
          << "between rows " << row + 1 << " and " << row + strides[axis] + 1;
    }
  }
}

}  // namespace
}  // namespace skylut
