#include "skylut/models/closed_form_sun.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/errors.hpp"
#include "support/test_atmosphere.hpp"

namespace skylut {
namespace {

// By hand: 33.885^-1.253 = 0.012104, times 0.15 = 0.0018156; 1/0.5018156 = 1.99276. At the zenith
// 93.885^-1.253 = 0.003375, so 0.99949. At the horizon 3.885^-1.253 = 0.18261: 1/0.027392 = 36.51.
TEST(ClosedForm, Kasten1966) {
  const auto mass = [](double zenith_deg) {
    return optical_masses(ClosedFormModel::iqbal, zenith_deg, 1013.25).ozone;
  };
  EXPECT_NEAR(mass(60.0), 1.99276, 1e-5);
  EXPECT_NEAR(mass(0.0), 0.99949, 1e-5);
  EXPECT_NEAR(mass(90.0), 36.51, 0.01);
  EXPECT_NEAR(optical_masses(ClosedFormModel::iqbal, 60.0, 506.625).rayleigh, 0.5 * 1.99276, 1e-5);
}

// Gueymard's masses lie near 1/cos z high up and part at the horizon: the thin high ozone least, the low
// water most. By hand at 90 deg: 1.76759e-3 * 90 * 4.37515^-1.21563 = 0.026447, hence 37.8; 14.3 and 71.4
// likewise.
TEST(ClosedForm, GueymardsMasses) {
  const OpticalMasses low = optical_masses(ClosedFormModel::smarts_like, 90.0, 1013.25);
  EXPECT_NEAR(low.rayleigh, 37.8, 0.1);
  EXPECT_NEAR(low.ozone, 14.3, 0.1);
  EXPECT_NEAR(low.water_vapour, 71.4, 0.1);
  const OpticalMasses high = optical_masses(ClosedFormModel::smarts_like, 60.0, 1013.25);
  for (const double mass : {high.rayleigh, high.ozone, high.water_vapour, high.aerosol, high.mixed_gases})
    EXPECT_NEAR(mass, 2.0, 0.04);
}

// Each factor by hand at 762.5 nm, m = 2: 0.7625^-4.08 = 3.0231, times 0.008735 and 2 = 0.052814; mixed gases
// 1.41 * 8 / (1 + 118.3 * 8)^0.45 = 11.28 / 21.841 = 0.51645; ozone 0.006 * 0.3438 * 2; aerosol 0.1 *
// 0.7625^-1.3 * 2.
TEST(ClosedForm, TransmittancesByHand) {
  const ClosedFormAir air{0.1, 1.3, 0.3438, 1.416};
  const ClosedFormAbsorption absorption = ClosedFormAbsorption::load(test::context);
  const std::vector<double> at =
      closed_form_transmittances(absorption, air, {2.0, 2.0, 2.0, 2.0, 2.0}, 762.5);
  ASSERT_EQ(at.size(), 5u);
  EXPECT_NEAR(at[0], std::exp(-0.008735 * std::pow(0.7625, -4.08) * 2.0), 1e-12);
  EXPECT_NEAR(at[0], 0.94856, 1e-4);
  EXPECT_NEAR(at[1], std::exp(-0.006 * 0.3438 * 2.0), 1e-12);
  EXPECT_NEAR(at[2], std::exp(-0.51645), 2e-4);
  EXPECT_NEAR(at[3], 1.0, 1e-4);
  EXPECT_NEAR(at[4], std::exp(-0.2 * std::pow(0.7625, -1.3)), 1e-12);
  // Water at 724.4 nm, k = 2.5: x = 2.5 * 1.416 * 2 = 7.08; 0.2385 x / (1 + 20.07 x)^0.45 = 1.68858 / 9.3270.
  const std::vector<double> wet =
      closed_form_transmittances(absorption, air, {2.0, 2.0, 2.0, 2.0, 2.0}, 724.4);
  EXPECT_NEAR(wet[3], std::exp(-0.2385 * 7.08 / std::pow(143.0956, 0.45)), 1e-9);
}

SkyScene scene() {
  SkyScene scene;
  scene.atmosphere = test::standard_atmosphere();
  scene.altitudes_km = {0.0};
  scene.turbidities = {{TurbidityKind::aod500, 0.084}};
  scene.suns = {{48.236, 180.0}};
  scene.wavelengths = WavelengthGrid(400.0, 660.0, 20.0);
  return scene;
}

// Where neither water nor oxygen absorbs, the closed forms agree with the shells to a few per cent: Leckner's
// Rayleigh is 1 % and the old ozone table a few per cent off ours.
TEST(ClosedForm, AgreesWithTheShellsBetweenTheBands) {
  const SunIrradiance shells = simulate_sun(test::context, scene(), {false, 0.0}, {});
  for (const ClosedFormModel model : {ClosedFormModel::iqbal, ClosedFormModel::smarts_like}) {
    const SunIrradiance closed = simulate_sun_closed_form(test::context, scene(), model);
    EXPECT_EQ(closed.extraterrestrial, shells.extraterrestrial);
    for (std::size_t i = 0; i < closed.direct_normal.size(); ++i)
      EXPECT_NEAR(closed.direct_normal[i] / shells.direct_normal[i], 1.0, 0.03) << closed.wavelengths[i];
  }
}

TEST(ClosedForm, RefusesWhatItCannotDo) {
  EXPECT_THROW(parse_closed_form_model("bird"), InputError);
  EXPECT_THROW(optical_masses(ClosedFormModel::iqbal, 90.1, 1013.25), InputError);
  EXPECT_THROW(optical_masses(ClosedFormModel::iqbal, 45.0, -1.0), InputError);
  SkyScene twilight = scene();
  twilight.suns = {{92.0, 0.0}};
  EXPECT_THROW(simulate_sun_closed_form(test::context, twilight, ClosedFormModel::iqbal), InputError);
}

}  // namespace
}  // namespace skylut
