#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/profile/profile.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

struct Published {
  double altitude_km;
  double temperature_K;
  double pressure_hPa;
};

// U.S. Standard Atmosphere 1976, table I (geometric altitude): five digits of pressure (a unit of the
// last is at most 1e-4), kinetic
// temperature. Between 80 and 86 km ours is the molecular-scale temperature, up to 0.08 K higher.
TEST(UsStandard1976, PublishedTable) {
  const Profile profile = load_profile(test::context, "ussa1976");
  for (const Published& level : {Published{0, 288.150, 1013.25},
                                 {1, 281.651, 898.76},
                                 {5, 255.676, 540.48},
                                 {10, 223.252, 264.99},
                                 {12, 216.650, 193.99},
                                 {20, 216.650, 55.293},
                                 {25, 221.552, 25.492},
                                 {30, 226.509, 11.970},
                                 {40, 250.350, 2.8714},
                                 {50, 270.650, 0.79779},
                                 {60, 247.021, 0.21958},
                                 {70, 219.585, 0.052209},
                                 {80, 198.639, 0.010524}}) {
    const AirState state = air_state(profile, level.altitude_km);
    EXPECT_NEAR(state.temperature_K, level.temperature_K, 0.011) << level.altitude_km;
    EXPECT_NEAR(state.pressure_hPa / level.pressure_hPa, 1.0, 1e-4) << level.altitude_km;
  }
}

// Above 86 km the standard adds up diffusing species, ours is hydrostatic air of its mean molar mass:
// 1.05 % more pressure at 100 km, above which a 3e-7th of the air remains.
TEST(UsStandard1976, AboveTheLayers) {
  const Profile profile = load_profile(test::context, "ussa1976");
  for (const Published& level :
       {Published{90, 186.87, 1.8359e-3}, {95, 188.42, 7.5966e-4}, {100, 195.08, 3.2011e-4}}) {
    EXPECT_NEAR(air_state(profile, level.altitude_km).temperature_K, level.temperature_K, 0.01)
        << level.altitude_km;
    EXPECT_NEAR(air_state(profile, level.altitude_km).pressure_hPa / level.pressure_hPa, 1.0, 1.1e-2)
        << level.altitude_km;
  }
}

// Hydrostatic air: N = ∫ N_A dp / (M g(z)) with the standard's decrease of gravity.
TEST(UsStandard1976, AirColumnIsPressureOverWeight) {
  const Profile profile = load_profile(test::context, "ussa1976");
  double column = 0.0;
  const auto gravity = [](double z) {
    return kStandardGravity_m_s2 * std::pow(6356.766 / (6356.766 + z), 2);
  };
  constexpr double kStep_km = 0.01;
  for (int i = 0; i < 10000; ++i) {
    const double z = i * kStep_km;
    const double above = std::min(z + kStep_km, 100.0);
    const double fall = air_state(profile, z).pressure_hPa - air_state(profile, above).pressure_hPa;
    column += 100.0 * fall * kAvogadro_per_mol / (28.9644e-3 * gravity(z + 0.5 * kStep_km));
  }
  // The 1976 gas constant is 1.7e-5 above SI 2019's k N_A.
  EXPECT_NEAR(air_column_per_m2(profile, 0.0, 100.0) / column, 1.0, 5e-5);
  // That is p0 N_A / (M g) with gravity at the mass-weighted mean altitude ∫ p dz / p0 = 7.3 km.
  EXPECT_NEAR(column / (101325.0 * kAvogadro_per_mol / (28.9644e-3 * gravity(7.3))), 1.0, 1e-4);
}

TEST(UsStandard1976, GasColumns) {
  const Profile profile = load_profile(test::context, "ussa1976");
  const auto column = [&](const char* gas) {
    return gas_column_per_m2(profile, *profile.gas(gas), 0.0, 100.0);
  };
  EXPECT_NEAR(column("ozone") / kDobsonUnit_per_m2, 343.8, 1e-9);
  // AFGL U.S. standard: 1.417 g/cm² of water (logarithmic between levels), 5.57e15 cm⁻² of NO2.
  EXPECT_NEAR(profile.quantities.front().precipitable_water_cm, 1.417, 0.003);
  EXPECT_NEAR(column("nitrogen_dioxide"), 5.57e19, 0.05e19);
  EXPECT_NEAR(column("oxygen") / air_column_per_m2(profile, 0.0, 100.0), 0.209476, 1e-4);
}

// Most ozone lies above 15 km, and the physical profile knows it.
TEST(UsStandard1976, PhysicalQuantities) {
  const Profile profile = load_profile(test::context, "ussa1976");
  const auto& levels = profile.quantities;
  ASSERT_GT(levels.size(), 15u);
  EXPECT_NEAR(levels[0].ozone_atm_cm, 0.3438, 1e-9);
  EXPECT_GT(levels[15].ozone_atm_cm, 0.7 * levels[0].ozone_atm_cm);
  // Mean temperature of the ozone: 225-235 K in the mid-latitudes (Komhyr et al. 1993 use 227 K).
  EXPECT_NEAR(levels[0].ozone_temperature_K, 229.0, 4.0);
  EXPECT_NEAR(levels[0].relative_humidity_percent, 46.0, 1.0);  // 1.97e17 cm⁻³ is 7.85 hPa of 17.05
}

}  // namespace
}  // namespace skylut
