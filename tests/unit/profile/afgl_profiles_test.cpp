#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/profile/profile.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

struct Published {
  const char* name;
  double ground_K;
  double ozone_atm_cm;
  double water_cm;
};

// Totals of the six model atmospheres as LOWTRAN 7 and MODTRAN print them (Anderson et al. 1986). Integration
// between levels (logarithmic here) makes up to 2 %.
const Published kPublished[] = {
    {"tropical", 299.7, 0.277, 4.11},
    {"midlatitude-summer", 294.2, 0.332, 2.92},
    {"midlatitude-winter", 272.2, 0.377, 0.853},
    {"subarctic-summer", 287.2, 0.345, 2.08},
    {"subarctic-winter", 257.2, 0.376, 0.417},
};

TEST(AfglProfiles, Columns) {
  for (const Published& published : kPublished) {
    const Profile profile = load_profile(test::context, published.name);
    EXPECT_EQ(profile.temperature_K.front(), published.ground_K);
    EXPECT_EQ(profile.described_top_km, 100.0);
    EXPECT_NEAR(profile.quantities.front().ozone_atm_cm / published.ozone_atm_cm, 1.0, 0.02)
        << published.name;
    EXPECT_NEAR(profile.quantities.front().precipitable_water_cm / published.water_cm, 1.0, 0.01)
        << published.name;
    const double no2_du =
        gas_column_per_m2(profile, *profile.gas("nitrogen_dioxide"), 0.0, 100.0) / kDobsonUnit_per_m2;
    EXPECT_NEAR(no2_du, 0.205, 0.02) << published.name;
  }
}

// p0 = ∫ ρ g dz: the air weighs what its pressure says. Standard gravity serves all five atmospheres; the
// real one of 15-60° differs by 0.28 %, and moist air is up to 0.5 % lighter than the ideal dry air of
// p/(kT).
TEST(AfglProfiles, HydrostaticBalance) {
  for (const Published& published : kPublished) {
    const Profile profile = load_profile(test::context, published.name);
    const auto gravity = [](double z) { return kStandardGravity_m_s2 * std::pow(6371.0 / (6371.0 + z), 2); };
    for (const auto& [lower_km, upper_km] :
         {std::pair{0.0, 10.0}, std::pair{10.0, 30.0}, std::pair{30.0, 60.0}}) {
      double weight_Pa = 0.0;
      for (double z = lower_km; z < upper_km - 1e-9; z += 0.1)
        weight_Pa += 28.9644e-3 / kAvogadro_per_mol * gravity(z + 0.05) *
                     air_column_per_m2(profile, z, std::min(z + 0.1, upper_km));
      const double fall_Pa =
          100.0 * (air_state(profile, lower_km).pressure_hPa - air_state(profile, upper_km).pressure_hPa);
      EXPECT_NEAR(weight_Pa / fall_Pa, 1.0, 0.01) << published.name << " from " << lower_km << " km";
    }
  }
}

// 1 km levels and the finer part between hold what AFGL-TR-86-0110 prints: figures at levels of both.
TEST(AfglProfiles, Levels) {
  const Profile tropical = load_profile(test::context, "tropical");
  EXPECT_NEAR(air_state(tropical, 17.0).temperature_K, 194.8, 1e-9);  // the cold tropopause
  EXPECT_NEAR(air_state(tropical, 30.0).pressure_hPa, 12.2, 1e-9);
  EXPECT_NEAR(interpolate_by_altitude(tropical, tropical.gas("water_vapour")->density_per_m3, 0.0), 6.353e23,
              1e19);
  const Profile winter = load_profile(test::context, "subarctic-winter");
  EXPECT_GT(air_state(winter, 1.0).temperature_K, air_state(winter, 0.0).temperature_K) << "inversion";
}

TEST(UpdateQuantities, FollowTheColumns) {
  Profile profile = load_profile(test::context, "tropical");
  scale_gas_column(profile, "ozone", 300.0 * kDobsonUnit_per_m2);
  update_quantities(profile);
  EXPECT_NEAR(profile.quantities.front().ozone_atm_cm, 0.3, 1e-9);
  Profile report = load_profile(test::context, "utm2005");
  const double printed = report.quantities.front().ozone_atm_cm;
  scale_gas_column(report, "ozone", 300.0 * kDobsonUnit_per_m2);
  update_quantities(report);
  EXPECT_EQ(report.quantities.front().ozone_atm_cm, printed);
}

TEST(SurfacePressure, ScalesAirAndWellMixedGases) {
  Profile profile = load_profile(test::context, "tropical");
  const Profile before = profile;
  scale_surface_pressure(profile, 0.8 * before.pressure_hPa.front());
  EXPECT_NEAR(air_column_per_m2(profile, 0.0, 100.0) / air_column_per_m2(before, 0.0, 100.0), 0.8, 1e-12);
  for (const GasProfile& gas : profile.gases) {
    const double ratio = gas_column_per_m2(profile, gas, 0.0, 100.0) /
                         gas_column_per_m2(before, *before.gas(gas.name), 0.0, 100.0);
    const bool well_mixed = gas.name == "oxygen" || gas.name == "carbon_dioxide";
    EXPECT_NEAR(ratio, well_mixed ? 0.8 : 1.0, 1e-9) << gas.name;
  }
}

}  // namespace
}  // namespace skylut
