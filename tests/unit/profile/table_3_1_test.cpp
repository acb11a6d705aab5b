#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/profile/profile.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

// Table 3.1 of the UTM report 2005 with its digits; half a unit of the last is the tolerance, except for
// T, which the report cuts off (288.15 is printed as 288.1): a whole unit.
struct Row {
  double z, temperature, pressure, ozone_temperature, humidity, oxygen, carbon_dioxide, water, ozone;
};
constexpr Row kTable[] = {
    {0, 288.1, 1013.3, 224.8, 14, 4.9293, 4.8649, 0.38560, 0.3434},
    {6, 249.2, 472.2, 213.69, 6, 1.2, 0.9614, 0.07051, 0.3249},
    {12, 216.6, 194.0, 204.42, 37, 0.2302, 0.1484, 0.03489, 0.3064},
    {20, 216.6, 55.29, 204.42, 5, 0.0216, 0.0122, 0.00471, 0.2817},
    {30, 226.5, 11.97, 207.23, 2, 0.0012, 0.0006, 0.00337, 0.2509},
};

TEST(Table31, PrintedDigits) {
  const Profile profile = load_profile(test::context, "utm2005");
  ASSERT_EQ(profile.quantities.size(), 16u);
  for (const Row& row : kTable) {
    const LevelQuantities& level = profile.quantities[static_cast<std::size_t>(row.z / 2.0)];
    ASSERT_EQ(level.altitude_km, row.z);
    EXPECT_NEAR(level.temperature_K, row.temperature, 0.1) << row.z;
    EXPECT_NEAR(level.pressure_hPa, row.pressure, row.z < 10 ? 0.0501 : 0.00501 * (row.z == 12 ? 10 : 1))
        << row.z;
    EXPECT_NEAR(level.ozone_temperature_K, row.ozone_temperature, row.z == 0 ? 0.0501 : 0.00501) << row.z;
    EXPECT_NEAR(level.oxygen_path_km, row.oxygen, row.z == 6 ? 0.0501 : 0.0000501) << row.z;
    EXPECT_NEAR(level.carbon_dioxide_path_km, row.carbon_dioxide, 0.0000501) << row.z;
    EXPECT_NEAR(level.ozone_atm_cm, row.ozone, 0.0000501) << row.z;
    EXPECT_NEAR(level.relative_humidity_percent, row.humidity, 1e-9) << row.z;  // data of the file
    EXPECT_NEAR(level.precipitable_water_cm, row.water, 1e-12) << row.z;
  }
}

// The ozone that light meets is eq. 3.12's: the column above every level of the report.
TEST(Table31, OzoneDensityGivesEquation312) {
  const Profile profile = load_profile(test::context, "utm2005");
  const GasProfile& ozone = *profile.gas("ozone");
  for (const LevelQuantities& level : profile.quantities)
    EXPECT_NEAR(gas_column_per_m2(profile, ozone, level.altitude_km, 100.0) / (1000.0 * kDobsonUnit_per_m2),
                level.ozone_atm_cm, 1e-9)
        << level.altitude_km;
}

// Water comes from slopes of a logarithm on 2 km levels that changes at the printed ones: 10 %.
TEST(Table31, WaterDensityGivesThePrintedColumn) {
  const Profile profile = load_profile(test::context, "utm2005");
  const double molecules_per_cm = 1e4 * kAvogadro_per_mol / 18.01528;
  const double column =
      gas_column_per_m2(profile, *profile.gas("water_vapour"), 0.0, 30.0) / molecules_per_cm;
  EXPECT_NEAR(column / (0.38560 - 0.00337), 1.0, 0.1);
}

// The sky above 30 km is real air.
TEST(Table31, ContinuesToTheTop) {
  const Profile profile = load_profile(test::context, "utm2005");
  const Profile standard = load_profile(test::context, "ussa1976");
  EXPECT_EQ(profile.described_top_km, 30.0);
  EXPECT_EQ(profile.altitude_km.back(), 100.0);
  for (double z : {0.0, 10.0, 30.0, 35.0, 60.0, 99.0})
    EXPECT_NEAR(air_state(profile, z).pressure_hPa / air_state(standard, z).pressure_hPa, 1.0, 1e-12) << z;
}

}  // namespace
}  // namespace skylut
