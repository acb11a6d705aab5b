#include "skylut/profile/profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Isothermal air of scale height 8 km on coarse levels, a gas of scale height 4 km.
Profile exponential() {
  Profile profile;
  profile.name = "exponential";
  for (double z : {0.0, 3.0, 10.0, 50.0, 100.0}) {
    profile.altitude_km.push_back(z);
    profile.temperature_K.push_back(250.0);
    profile.pressure_hPa.push_back(1000.0 * std::exp(-z / 8.0));
  }
  profile.gases.push_back({"ozone", {}});
  for (double z : profile.altitude_km) profile.gases[0].density_per_m3.push_back(1e18 * std::exp(-z / 4.0));
  return profile;
}

// ∫ n0 exp(-z/H) dz = n0 H (exp(-a/H) - exp(-b/H)), whatever the levels.
TEST(Profile, ExponentialColumnsAreExact) {
  const Profile profile = exponential();
  const double n0 = 1e5 / (kBoltzmann_J_per_K * 250.0);
  for (const auto& [a, b] : {std::pair{0.0, 100.0}, {1.5, 2.5}, {2.0, 40.0}, {7.0, 7.0}}) {
    const double air = n0 * 8000.0 * (std::exp(-a / 8.0) - std::exp(-b / 8.0));
    const double gas = 1e18 * 4000.0 * (std::exp(-a / 4.0) - std::exp(-b / 4.0));
    EXPECT_NEAR(air_column_per_m2(profile, a, b), air, 1e-8 * air) << a << " " << b;
    EXPECT_NEAR(gas_column_per_m2(profile, profile.gases[0], a, b), gas, 1e-9 * gas) << a << " " << b;
  }
}

// Air of constant lapse rate: p = p0 (T/T0)^(M g/(R L)) between two levels, at any altitude in between.
TEST(Profile, ConstantLapseRateIsExactBetweenLevels) {
  Profile profile = exponential();
  const double exponent = 5.0;
  for (std::size_t i = 0; i < profile.altitude_km.size(); ++i) {
    profile.temperature_K[i] = 300.0 - 2.0 * profile.altitude_km[i];
    profile.pressure_hPa[i] = 1000.0 * std::pow(profile.temperature_K[i] / 300.0, exponent);
  }
  for (double z : {0.0, 1.0, 6.5, 30.0, 99.0}) {
    const AirState state = air_state(profile, z);
    EXPECT_NEAR(state.temperature_K, 300.0 - 2.0 * z, 1e-12);
    EXPECT_NEAR(state.pressure_hPa / (1000.0 * std::pow((300.0 - 2.0 * z) / 300.0, exponent)), 1.0, 1e-12)
        << z;
    EXPECT_NEAR(state.density_per_m3 * kBoltzmann_J_per_K * state.temperature_K, 100.0 * state.pressure_hPa,
                1e-9 * state.pressure_hPa * 100.0);
  }
}

// A level without gas: linear to zero, ∫ = triangle.
TEST(Profile, GasThatEnds) {
  Profile profile = exponential();
  profile.gases[0].density_per_m3 = {2e18, 0.0, 0.0, 0.0, 0.0};
  EXPECT_NEAR(gas_column_per_m2(profile, profile.gases[0], 0.0, 100.0), 2e18 * 3000.0 / 2.0, 1e9);
  EXPECT_NEAR(gas_column_per_m2(profile, profile.gases[0], 1.0, 2.0), 2e18 * 1000.0 / 2.0, 1e9);
}

TEST(Profile, ScalingAColumn) {
  Profile profile = exponential();
  scale_gas_column(profile, "ozone", 5e22);
  EXPECT_NEAR(gas_column_per_m2(profile, profile.gases[0], 0.0, 100.0), 5e22, 1e10);
  EXPECT_THROW(scale_gas_column(profile, "ozone", -1.0), InputError);
  EXPECT_THROW(scale_gas_column(profile, "ozone", NAN), InputError);
  EXPECT_THROW(scale_gas_column(profile, "argon", 1.0), InputError);
}

TEST(Profile, OutsideIsRefused) {
  const Profile profile = exponential();
  EXPECT_THROW(air_state(profile, -0.001), InputError);
  EXPECT_THROW(air_state(profile, 100.001), InputError);
  EXPECT_THROW(air_column_per_m2(profile, 5.0, 4.0), InputError);
}

TEST(Profile, NamesAreThoseThatLoad) {
  const std::vector<std::string> names = profile_names(test::context);
  EXPECT_NE(std::find(names.begin(), names.end(), "ussa1976"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "utm2005"), names.end());
  for (const std::string& name : names) EXPECT_EQ(load_profile(test::context, name).name, name);
}

}  // namespace
}  // namespace skylut
