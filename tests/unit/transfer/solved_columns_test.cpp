#include "skylut/transfer/solved_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sky_cases.hpp"
#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

/// Different numbers of scatterers; the last one has a forward peak.
const std::vector<OpticalColumn>& columns() {
  static const std::vector<OpticalColumn> all{
      test::column_of({.rayleigh_depth = 0.2, .ground_albedo = 0.3}),
      test::column_of({.rayleigh_depth = 0.1, .haze_depth = 0.3, .haze_asymmetry = 0.6}),
      test::column_of({.rayleigh_depth = 0.1, .haze_depth = 0.4, .haze_asymmetry = 0.93})};
  return all;
}
const std::vector<double> kSuns_deg{30.0, 89.0};
const std::vector<double> kAzimuths_deg{0.0, 10.0, 100.0, 180.0};

SolvedColumns solved() { return {test::context, test::earth(), columns(), kSuns_deg, {}}; }

// The solver taken apart gives the radiances of the solver in one piece, to the last bit.
TEST(SolvedColumns, AnswersAsTheSolverDoes) {
  SkyRequest request{{0.0, 4.0}, kSuns_deg, {}};
  for (const double azimuth_deg : kAzimuths_deg) request.views.push_back({85.0, azimuth_deg});
  const SkyRadiance together = solve_sky_radiance(test::context, test::earth(), columns(), request, {});
  const SolvedColumns apart = solved();
  std::vector<float> radiance(columns().size() * kAzimuths_deg.size());
  for (std::size_t o = 0; o < 2; ++o)
    for (std::size_t s = 0; s < 2; ++s) {
      apart.radiance({request.observer_altitudes_km[o], 85.0, kSuns_deg[s], kAzimuths_deg}, radiance);
      for (std::size_t c = 0; c < columns().size(); ++c)
        for (std::size_t v = 0; v < kAzimuths_deg.size(); ++v)
          EXPECT_EQ(radiance[c * kAzimuths_deg.size() + v], together.at(c, o, s, v)) << o << s << c << v;
    }
}

// The parts times their factors are the radiance: near the sun, where the forward peak's correction is felt,
// and far from it. Parts of single precision, of which the peak's partly cancel.
TEST(SolvedColumns, PartsMakeTheRadiance) {
  const SolvedColumns apart = solved();
  ASSERT_EQ(apart.parts(), 7u);
  const std::size_t azimuths = kAzimuths_deg.size();
  std::vector<float> radiance(columns().size() * azimuths);
  std::vector<float> parts(apart.parts() * azimuths * columns().size());
  std::vector<double> factors(apart.parts());
  bool peak_counts = false;
  for (const double sun_deg : kSuns_deg)
    for (const double view_deg : {27.0, 88.0, 92.0, 150.0}) {
      apart.radiance({4.0, view_deg, sun_deg, kAzimuths_deg}, radiance);
      const SightLine line{4.0, view_deg, sun_deg, kAzimuths_deg};
      apart.radiance_parts({&line, 1}, parts);
      for (std::size_t c = 0; c < columns().size(); ++c)
        for (std::size_t v = 0; v < azimuths; ++v) {
          const double zenith = view_deg * kRadiansPerDegree;
          const double sun = sun_deg * kRadiansPerDegree;
          const double cosine =
              std::cos(zenith) * std::cos(sun) +
              std::sin(zenith) * std::sin(sun) * std::cos(kAzimuths_deg[v] * kRadiansPerDegree);
          apart.part_factors(c, cosine, factors);
          double sum = 0.0;
          for (std::size_t part = 0; part < apart.parts(); ++part)
            sum += factors[part] * static_cast<double>(parts[(part * azimuths + v) * columns().size() + c]);
          const auto expected = static_cast<double>(radiance[c * azimuths + v]);
          EXPECT_NEAR(sum / expected, 1.0, 1e-5) << sun_deg << " " << view_deg << " " << c << " " << v;
          peak_counts = peak_counts || factors[3] != 0.0;
        }
    }
  EXPECT_TRUE(peak_counts);
}

// A line under many suns at once is each of them alone, to the last bit: of one band and of several, whose
// suns stand between those of another.
TEST(SolvedColumns, AFanIsItsLines) {
  const std::vector<double> suns_deg{89.0, 30.0, 35.0, 89.5};
  for (const bool bands : {true, false}) {
    TransferOptions options;
    options.discretisation.sun_bands = bands;
    const SolvedColumns sky(test::context, test::earth(), columns(), suns_deg, options);
    const std::size_t size = sky.parts() * kAzimuths_deg.size() * columns().size();
    std::vector<float> fan(suns_deg.size() * size);
    std::vector<float> alone(size);
    for (const double view_deg : {40.0, 91.0, 120.0}) {
      sky.radiance_parts(SightFan{4.0, view_deg, suns_deg, kAzimuths_deg}, fan);
      for (std::size_t sun = 0; sun < suns_deg.size(); ++sun) {
        const SightLine line{4.0, view_deg, suns_deg[sun], kAzimuths_deg};
        sky.radiance_parts({&line, 1}, alone);
        for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(fan[sun * size + i], alone[i]) << bands << sun << i;
      }
    }
  }
}

// A line whose lowest point lies on a boundary of layers, to the last digits: it has a piece of no length
// there.
TEST(SolvedColumns, LinesThatTouchALevel) {
  const SolvedColumns apart = solved();
  const std::vector<double> azimuth{90.0};
  std::vector<float> radiance(columns().size());
  for (const double level_km : {1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0})
    for (int ulps = -2; ulps <= 2; ++ulps) {
      double zenith_deg = 180.0 - std::asin((6371.0 + level_km) / 6383.0) * kDegreesPerRadian;
      for (int i = 0; i < std::abs(ulps); ++i)
        zenith_deg = std::nextafter(zenith_deg, ulps > 0 ? 180.0 : 0.0);
      EXPECT_NO_THROW(apart.radiance({12.0, zenith_deg, 30.0, azimuth}, radiance)) << level_km << " " << ulps;
      std::vector<float> beside(columns().size());
      apart.radiance({12.0, zenith_deg + 1e-4, 30.0, azimuth}, beside);
      EXPECT_NEAR(radiance[2] / beside[2], 1.0f, 0.01f) << level_km << " " << ulps;
    }
}

TEST(SolvedColumns, RefusesSunsOfOtherBands) {
  const SolvedColumns apart = solved();
  std::vector<float> radiance(columns().size());
  const std::vector<double> azimuth{0.0};
  EXPECT_NO_THROW(apart.radiance({0.0, 40.0, 33.0, azimuth}, radiance));
  EXPECT_THROW(apart.radiance({0.0, 40.0, 60.0, azimuth}, radiance), InputError);
  EXPECT_THROW(apart.radiance({0.0, 40.0, 100.0, azimuth}, radiance), InputError);
  EXPECT_THROW(apart.radiance({0.0, 181.0, 33.0, azimuth}, radiance), InputError);
  EXPECT_THROW(SolvedColumns(test::context, test::earth(), columns(), std::vector{100.0}, {}), InputError);
}

}  // namespace
}  // namespace skylut
