#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

#include "sky_cases.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

struct Ends {
  const char* name;
  double lowest;
  double highest;
};
constexpr Ends kEnds[] = {{"optical-step", 1e-3, 1.0},     {"truncated-peak", 1e-4, 0.1},
                          {"narrow-peak-degrees", 2, 30},  {"polar-per-degree", 0.5, 4.0},
                          {"polar-nodes", 4, 64},          {"sun-nodes", 0, 4},
                          {"merge-layers", 0, 1},          {"ray-step-km", 0.1, 100.0},
                          {"sunbeam-step-km", 0.01, 10.0}, {"tolerance", 1e-6, 0.1}};

/// Thin haze in two low layers, quickly solved; a peak narrow enough to need every Legendre degree there is.
OpticalColumn haze(double depth) {
  const std::vector<double> half{0.5 * depth, 0.5 * depth};
  return {{depth, depth},
          {{std::make_shared<const RayleighPhaseFunction>(), half},
           {std::make_shared<const HenyeyGreensteinPhaseFunction>(0.93), half}},
          0.2};
}

SkyRadiance solved(const DiscretisationOptions& discretisation, double depth, double top_km) {
  const Shells shells{{0.0, 0.3 * top_km, top_km}, 6371.0};
  const SkyRequest request{
      {0.0, 0.3 * top_km}, {30.0, 91.0}, {{0.0, 0.0}, {31.0, 0.0}, {89.5, 120.0}, {100.0, 10.0}}};
  TransferOptions options;
  options.discretisation = discretisation;
  options.discretisation.polarised_degree = 0;
  const OpticalColumn column = haze(depth);
  return solve_sky_radiance(test::context, shells, std::span(&column, 1), request, options);
}

void expect_sane(const SkyRadiance& sky, const SkyRadiance& expected, double relative,
                 const std::string& what) {
  for (std::size_t o = 0; o < 2; ++o)
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t v = 0; v < 4; ++v) {
        const float value = sky.at(0, o, s, v);
        EXPECT_TRUE(std::isfinite(value) && value >= 0.0f) << what << " " << o << s << v;
        if (s > 0) continue;
        EXPECT_NEAR(value / expected.at(0, o, s, v), 1.0, relative) << what << " " << o << v;
      }
}

// Each number at its ends, all else as in the quality draft: the day's radiances stay within what so coarse
// numbers cost. (In twilight they are only asked to be numbers.)
TEST(DiscretisationLimits, EachAtItsEnds) {
  const SkyRadiance expected = solved(discretisation_of(Quality::standard), 0.02, 1.0);
  for (const Ends& ends : kEnds)
    for (const double value : {ends.lowest, ends.highest}) {
      DiscretisationOptions options = discretisation_of(Quality::draft);
      set_discretisation(options, ends.name, value);
      expect_sane(solved(options, 0.02, 1.0), expected, 0.1, fmt::format("{} {}", ends.name, value));
    }
}

// All of them at once at the coarse and at the fine end: 4 and 120 polar, 4 and 24 azimuth, 33 and 261 sun
// nodes.
TEST(DiscretisationLimits, AllAtTheirEnds) {
  const SkyRadiance expected = solved(discretisation_of(Quality::standard), 5e-4, 0.03);
  DiscretisationOptions coarse = discretisation_of(Quality::draft);
  DiscretisationOptions fine = coarse;
  for (const Ends& ends : kEnds) {
    const std::string name = ends.name;
    const bool more_is_finer = name == "narrow-peak-degrees" || name == "polar-per-degree" ||
                               name == "polar-nodes" || name == "sun-nodes";
    set_discretisation(fine, name, more_is_finer ? ends.highest : ends.lowest);
    set_discretisation(coarse, name, more_is_finer ? ends.lowest : ends.highest);
  }
  expect_sane(solved(coarse, 5e-4, 0.03), expected, 0.2, "coarse");
  expect_sane(solved(fine, 5e-4, 0.03), expected, 0.03, "fine");
}

TEST(DiscretisationLimits, RefusedBeyond) {
  for (const Ends& ends : kEnds)
    for (const double value :
         {std::nextafter(ends.lowest, -1.0), std::nextafter(ends.highest, 1e9), std::nan("")}) {
      DiscretisationOptions options = discretisation_of(Quality::draft);
      EXPECT_THROW(set_discretisation(options, ends.name, value), InputError) << ends.name << value;
    }
  DiscretisationOptions options = discretisation_of(Quality::draft);
  EXPECT_THROW(set_discretisation(options, "polar-nodes", 4.5), InputError);
  EXPECT_THROW(set_discretisation(options, "orders", 4.0), InputError);
}

// More sun nodes change little: the 33 chosen ones are good to 0.2 % by day and 0.7 % to the end of civil
// twilight [docs/validation.md, "Convergence"].
TEST(DiscretisationLimits, SunNodesHaveConverged) {
  const OpticalColumn column = test::column_of(
      {.rayleigh_depth = 0.1, .haze_depth = 0.1, .haze_scattering_albedo = 0.95, .ground_albedo = 0.2});
  const SkyRequest request{{0.0, 12.0}, {20.0, 75.0, 90.0, 94.0}, {{0.0, 0.0}, {60.0, 90.0}, {85.0, 0.0}}};
  const auto with_density = [&](int density) {
    TransferOptions options = test::unpolarised(Quality::draft);
    options.discretisation.sun_node_density = density;
    return solve_sky_radiance(test::context, test::earth(), std::span(&column, 1), request, options);
  };
  const SkyRadiance chosen = with_density(0);
  for (const int density : {2, 4}) {
    const SkyRadiance finer = with_density(density);
    for (std::size_t o = 0; o < 2; ++o)
      for (std::size_t s = 0; s < 4; ++s)
        for (std::size_t v = 0; v < 3; ++v)
          EXPECT_NEAR(chosen.at(0, o, s, v) / finer.at(0, o, s, v), 1.0, s < 2 ? 2e-3 : 7e-3)
              << density << " " << o << s << v;
  }
}

}  // namespace
}  // namespace skylut
