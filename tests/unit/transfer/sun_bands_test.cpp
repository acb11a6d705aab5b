#include "spherical/sun_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"

namespace skylut::transfer {
namespace {

DiscretisationOptions with_bands(bool bands) {
  DiscretisationOptions options = discretisation_of(Quality::standard);
  options.sun_bands = bands;
  return options;
}

// Every sun has a band, whose nodes surround it.
TEST(SunBands, HoldTheirSuns) {
  const std::vector<SunBand> bands = sun_bands(with_bands(true));
  for (double sun_deg = 0.0; sun_deg <= 99.0; sun_deg += 0.25) {
    const SunBand& band = bands[band_of(bands, sun_deg)];
    EXPECT_GE(band.nodes_deg.size(), 4u) << sun_deg;
    EXPECT_LE(band.nodes_deg.front(), sun_deg);
    EXPECT_GT(band.nodes_deg.back(), sun_deg);
  }
  EXPECT_EQ(sun_bands(with_bands(false)).size(), 3u);
}

// What the nodes left out would change: 0.25 % at the ends of bands and in the dark, where the sky's light
// comes from the day, less elsewhere.
TEST(SunBands, NodesLeftOutHardlyMatter) {
  const OpticalColumn column = test::column_of(
      {.rayleigh_depth = 0.1, .haze_depth = 0.2, .haze_asymmetry = 0.7, .ground_albedo = 0.2});
  const SkyRequest request{
      {0.0, 12.0},
      {0.0, 24.9, 25.1, 51.9, 52.1, 71.9, 72.1, 81.9, 82.1, 87.4, 87.6, 90.0, 90.9, 91.1, 93.9, 94.1, 96.0},
      {{0.0, 0.0}, {60.0, 0.0}, {85.0, 90.0}, {89.5, 0.0}, {89.5, 180.0}, {92.0, 180.0}}};
  TransferOptions options;
  options.discretisation = with_bands(true);
  const SkyRadiance banded = solve_sky_radiance(test::context, test::earth(), {&column, 1}, request, options);
  options.discretisation = with_bands(false);
  options.discretisation.tolerance = 3e-4;
  const SkyRadiance whole = solve_sky_radiance(test::context, test::earth(), {&column, 1}, request, options);
  for (std::size_t o = 0; o < 2; ++o)
    for (std::size_t s = 0; s < request.sun_zeniths_deg.size(); ++s)
      for (std::size_t v = 0; v < request.views.size(); ++v)
        EXPECT_NEAR(banded.at(0, o, s, v) / whole.at(0, o, s, v), 1.0f, 2.5e-3f)
            << o << " sun " << request.sun_zeniths_deg[s] << " view " << request.views[v].zenith_deg;
}

}  // namespace
}  // namespace skylut::transfer
