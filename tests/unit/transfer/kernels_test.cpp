#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "geometry/ray.hpp"
#include "sky_cases.hpp"
#include "skylut/core/errors.hpp"
#include "spherical/block_optics.hpp"
#include "spherical/kernel_choice.hpp"
#include "spherical/ray_sources.hpp"
#include "spherical/solved_block.hpp"
#include "spherical/sweep_tables.hpp"

namespace skylut {
namespace {

const SkyRequest kRequest = {
    {0.0, 12.0},
    {0.0, 60.0, 88.0, 94.0},
    {{0.0, 0.0}, {59.0, 0.0}, {70.0, 45.0}, {90.0, 180.0}, {95.0, 90.0}, {180.0, 0.0}}};

std::vector<OpticalColumn> columns() {
  std::vector<OpticalColumn> made;
  for (const double haze : {0.0, 0.2, 1.0})
    made.push_back(test::column_of({.rayleigh_depth = 0.1,
                                    .haze_depth = haze,
                                    .haze_scattering_albedo = 0.95,
                                    .haze_asymmetry = 0.8,
                                    .absorption_depth = 0.02,
                                    .ground_albedo = 0.3}));
  return made;
}

SkyRadiance solved(Simd simd) {
  return solve_sky_radiance(test::with_simd(simd), test::earth(), columns(), kRequest, {});
}

/// Largest relative difference of two skies.
double difference(const SkyRadiance& a, const SkyRadiance& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t o = 0; o < 2; ++o)
      for (std::size_t s = 0; s < 4; ++s)
        for (std::size_t v = 0; v < 6; ++v)
          largest = std::max(largest, std::abs(1.0 - static_cast<double>(a.at(c, o, s, v)) /
                                                         static_cast<double>(b.at(c, o, s, v))));
  return largest;
}

/// One line of sight of a small block in a build on V.
template <class V>
std::vector<float> line_of_sight() {
  using namespace transfer;
  const std::vector<OpticalColumn> all = columns();
  const CommonGrid common(test::earth(), discretisation_of(Quality::draft));
  const Discretisation grid(common, discretisation_for(common.merge, common.discretisation, all[1]));
  const SweepTables tables(grid);
  const OpticalColumn* const column = &all[1];
  const BlockOptics optics(grid, std::span(&column, 1), kLaneCount<V>, true);
  const OpticsView view = optics.view();
  IterationReport report;
  const std::unique_ptr<SolvedBlock> block(solve_block<V>(tables.view(), view,
                                                          {.scattering_orders = 0,
                                                           .max_iterations = 50,
                                                           .tolerance = 1e-3f,
                                                           .cancelled = nullptr,
                                                           .token = nullptr},
                                                          report));
  EXPECT_EQ(report.end, IterationReport::kConverged);
  const std::vector<SunAzimuth> pairs{{30.0, 0.0}, {80.0, 120.0}};
  Ray ray(common.ray_space(), 0.0, 40.0, pairs, grid.angles.azimuthal_orders());
  const RaySources sources(grid, ray, false);
  std::vector<float> radiance(pairs.size() * kLaneCount<V>);
  block->line_of_sight(ray.view(), sources.view(), optics.phases(ray).data(), optics.peaks(ray).data(),
                       nullptr, radiance.data());
  return radiance;
}

// The kernels' text is the same for a register and for a plain number. In a plain float the operations are
// those of one lane; in double only the tables are single.
TEST(Kernels, PlainNumbers) {
  using transfer::LaneRegister;
  const std::vector<float> lanes = line_of_sight<LaneRegister<4>::type>();
  const std::vector<float> single = line_of_sight<float>();
  const std::vector<float> twice = line_of_sight<double>();
  for (std::size_t pair = 0; pair < 2; ++pair) {
    EXPECT_EQ(single[pair], lanes[4 * pair]);
    EXPECT_EQ(lanes[4 * pair + 3], lanes[4 * pair]);
    EXPECT_NEAR(twice[pair] / lanes[4 * pair], 1.0, 1e-5);
  }
}

// Rounding of single precision through some ten iterations, in twilight beside subtractions: 1e-5.
TEST(Kernels, AgreeWithDoublePrecision) {
  const SkyRadiance reference = solved(Simd::reference);
  EXPECT_EQ(reference.report().kernel, "reference");
  for (const Simd simd : {Simd::portable, Simd::best}) {
    const SkyRadiance sky = solved(simd);
    RecordProperty("difference_" + sky.report().kernel, std::to_string(difference(sky, reference)));
    EXPECT_LT(difference(sky, reference), 1e-5) << sky.report().kernel;
  }
}

// Fused multiply-adds are the same operations in 8 and 16 lanes.
TEST(Kernels, WideOnesGiveTheSameBytes) {
  try {
    const SkyRadiance wide = solved(Simd::avx512);
    const SkyRadiance narrow = solved(Simd::avx2);
    EXPECT_EQ(difference(wide, narrow), 0.0);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("kernel avx"), std::string::npos) << error.what();
    GTEST_SKIP() << error.what();
  }
}

}  // namespace
}  // namespace skylut
