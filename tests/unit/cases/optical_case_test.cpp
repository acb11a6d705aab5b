#include "skylut/cases/optical_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/cases/solve_case.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

OpticalCaseRequest request() {
  OpticalCaseRequest request;
  request.aod500 = 0.3;
  request.altitude_km = 1.0;
  request.sun_zenith_deg = 60.0;
  request.views = {{0.0, 0.0}, {59.0, 2.0}, {60.0, 90.0}, {85.0, 180.0}, {120.0, 45.0}};
  return request;
}

// The case is the same air: solving it gives the radiances of the air's own columns. 1e-4: moments end where
// they add 1e-7 to the phase function, radiances are 32-bit floats.
TEST(OpticalCase, SolvesToTheSameRadiances) {
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), {});
  const auto solved = solve_case(test::context, optical_case(air, request()), "case", {});
  const std::vector<BandColumn> terms = air.band_columns({550.0, 5.0}, 0.3);
  ASSERT_EQ(terms.size(), 1u);
  TransferOptions unpolarised;  // as a case is that does not ask for more
  unpolarised.discretisation.polarised_degree = 0;
  const SkyRadiance sky = solve_sky_radiance(test::context, air.shells(), {&terms[0].column, 1},
                                             {{1.0}, {60.0}, request().views}, unpolarised);
  for (std::size_t i = 0; i < request().views.size(); ++i)
    EXPECT_NEAR(solved["results"][i]["radiance"].get<double>() / sky.at(0, 0, 0, i), 1.0, 1e-4) << i;
}

TEST(OpticalCase, HoldsTheAirsDepths) {
  AtmosphereOptions options;
  options.ground_albedo = GroundAlbedo::load(test::context, "grass");
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), options);
  const auto document = optical_case(air, request());
  double rayleigh = 0.0;
  double aerosol = 0.0;
  for (const auto& layer : document["layers"]) {
    rayleigh += layer["tau_rayleigh"].get<double>();
    aerosol += layer["tau_aerosol"].get<double>();
    if (layer.contains("phase_moments_aerosol")) {  // no haze is left at 100 km
      EXPECT_NEAR(layer["phase_moments_aerosol"][1].get<double>(), layer["g_aerosol"].get<double>(), 1e-9);
    }
  }
  EXPECT_NEAR(rayleigh, air.rayleigh_depth(550.0), 1e-6);
  EXPECT_NEAR(aerosol, 0.3 * air.options().aerosol.relative_depth(550.0), 1e-6);
  EXPECT_NEAR(document["albedo"].get<double>(), options.ground_albedo.at(550.0, 5.0), 1e-12);
}

TEST(OpticalCase, WithoutAerosolThereAreNoMoments) {
  OpticalCaseRequest clear = request();
  clear.aod500 = 0.0;
  const auto document =
      optical_case(Atmosphere(test::context, load_profile(test::context, "ussa1976"), {}), clear);
  EXPECT_FALSE(document["layers"][0].contains("phase_moments_aerosol"));
  EXPECT_NO_THROW(solve_case(test::context, document, "case", {}));
}

TEST(OpticalCase, TermsAreChosenByNumber) {
  OpticalCaseRequest chosen = request();
  chosen.absorption_term = 1;
  EXPECT_EQ(optical_case(Atmosphere(test::context, load_profile(test::context, "ussa1976"), {}),
                         chosen)["absorption_term_weight"],
            1.0);
  chosen.absorption_term = 2;
  EXPECT_THROW(optical_case(Atmosphere(test::context, load_profile(test::context, "ussa1976"), {}), chosen),
               InputError);
}

// Moments stand instead of the asymmetry; a wrong list or depolarisation is named.
TEST(OpticalCase, SolveRefusesBrokenMoments) {
  const auto refused = [](const auto& spoil, const std::string& named) {
    auto document =
        optical_case(Atmosphere(test::context, load_profile(test::context, "ussa1976"), {}), request());
    spoil(document);
    try {
      solve_case(test::context, document, "case.json", {});
      ADD_FAILURE() << named;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  refused([](auto& d) { d["layers"][0]["phase_moments_aerosol"][0] = 0.5; }, "the first moment must be 1");
  refused([](auto& d) { d["layers"][3]["phase_moments_aerosol"][2] = 2.0; }, "layers[3]");
  refused([](auto& d) { d["rayleigh_depolarisation"] = 0.7; }, "rayleigh_depolarisation");
}

}  // namespace
}  // namespace skylut
