#include "skylut/atmosphere/turbidity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

const Atmosphere& standard_air() {
  static const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), {});
  return air;
}

TEST(Turbidity, NamesRoundTrip) {
  for (TurbidityKind kind : turbidity_kinds())
    EXPECT_EQ(parse_turbidity_kind(std::string(turbidity_kind_name(kind))), kind);
  try {
    parse_turbidity_kind("linke");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "turbidity kind 'linke': unknown; expected one of aod500, aod550, angstrom-beta, preetham-t, "
        "visibility-km");
  }
}

TEST(Turbidity, EveryKindBothWays) {
  for (TurbidityKind kind : turbidity_kinds())
    for (double aod500 : {0.0, 0.01, 0.1, 0.5, 1.0, 3.0})
      EXPECT_NEAR(to_aod500({kind, from_aod500(aod500, kind, standard_air())}, standard_air()), aod500,
                  1e-12 * (1.0 + aod500))
          << turbidity_kind_name(kind) << " " << aod500;
  // Below the stratospheric load hardly any aerosol is at the ground: visibility barely feels it.
  const double visibility = from_aod500(0.003, TurbidityKind::visibility_km, standard_air());
  EXPECT_NEAR(to_aod500({TurbidityKind::visibility_km, visibility}, standard_air()), 0.003, 1e-7);
}

// By hand, Ångström exponent 1.3: β = τ500 0.5^1.3; τ550 = τ500 1.1^-1.3; T = 1 + τ550/0.0971.
TEST(Turbidity, ValuesByHand) {
  EXPECT_NEAR(from_aod500(0.5, TurbidityKind::angstrom_beta, standard_air()), 0.5 * std::pow(0.5, 1.3),
              1e-12);
  EXPECT_NEAR(from_aod500(0.5, TurbidityKind::aod550, standard_air()), 0.5 * std::pow(1.1, -1.3), 1e-12);
  EXPECT_NEAR(from_aod500(0.5, TurbidityKind::preetham_t, standard_air()),
              1.0 + 0.5 * std::pow(1.1, -1.3) / 0.0971, 5e-3);
  EXPECT_EQ(from_aod500(0.0, TurbidityKind::preetham_t, standard_air()), 1.0);
  // Ground extinction at 550 nm: 0.01149 + (0.5 - 0.005) 1.1^-1.3 / 2 km.
  EXPECT_NEAR(from_aod500(0.5, TurbidityKind::visibility_km, standard_air()),
              3.912 / (0.01149 + 0.495 * std::pow(1.1, -1.3) / 2.0), 0.01);
}

// Without aerosol one sees 340 km through air at sea level (Koschmieder, 550 nm).
TEST(Turbidity, VisibilityOfPureAir) {
  const double clear_km = from_aod500(0.0, TurbidityKind::visibility_km, standard_air());
  EXPECT_NEAR(clear_km, 340.4, 1.0);
  EXPECT_NEAR(to_aod500({TurbidityKind::visibility_km, clear_km}, standard_air()), 0.0, 1e-12);
  EXPECT_EQ(
      to_aod500({TurbidityKind::visibility_km, std::numeric_limits<double>::infinity()}, standard_air()),
      0.0);
}

TEST(Turbidity, ImpossibleValuesAreRefused) {
  const auto refused = [](TurbidityKind kind, double value) {
    EXPECT_THROW(to_aod500({kind, value}, standard_air()), InputError)
        << turbidity_kind_name(kind) << " " << value;
  };
  for (TurbidityKind kind : turbidity_kinds()) {
    refused(kind, -0.1);
    refused(kind, NAN);
    if (kind != TurbidityKind::visibility_km) refused(kind, INFINITY);
  }
  refused(TurbidityKind::preetham_t, 0.99);
  refused(TurbidityKind::visibility_km, 0.0);
  refused(TurbidityKind::visibility_km, 400.0);
  EXPECT_THROW(from_aod500(-1.0, TurbidityKind::aod500, standard_air()), InputError);
}

// Iqbal 1983, table 6.6.1: β = 0.1 for 28 km ("clear"), 0.2 for 11 km ("turbid"), 0.4 for 5 km ("very
// turbid") at α = 1.3, to the digits given.
TEST(Turbidity, McClatcheySelby) {
  EXPECT_NEAR(mcclatchey_selby_beta(28.0, 1.3), 0.10, 0.005);
  EXPECT_NEAR(mcclatchey_selby_beta(11.0, 1.3), 0.20, 0.01);
  EXPECT_NEAR(mcclatchey_selby_beta(5.0, 1.3), 0.40, 0.01);
  for (double visibility_km : {2.0, 5.0, 23.0, 100.0, 336.0})
    EXPECT_NEAR(
        mcclatchey_selby_visibility_km(mcclatchey_selby_beta(visibility_km, 1.3), 1.3) / visibility_km, 1.0,
        1e-12);
  EXPECT_NEAR(mcclatchey_selby_visibility_km(0.0, 1.3), 3.912 / 0.01162, 1e-9);
  EXPECT_THROW(mcclatchey_selby_beta(337.0, 1.3), InputError);
  EXPECT_THROW(mcclatchey_selby_beta(0.0, 1.3), InputError);
  EXPECT_THROW(mcclatchey_selby_visibility_km(-0.1, 1.3), InputError);
}

}  // namespace
}  // namespace skylut
