#include "skylut/sky/limb_darkening.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/test_context.hpp"

namespace skylut {
namespace {

// Mean radiance of the disc over its centre's: the last column of Neckel & Labs 1994, table I.
TEST(LimbDarkening, PublishedMeanOverCentre) {
  const LimbDarkening darkening = LimbDarkening::load(test::context);
  const auto mean_over_centre = [&](double wavelength_nm) { return 1.0 / darkening.at(wavelength_nm)(1.0); };
  EXPECT_NEAR(mean_over_centre(310.843), 0.6883, 1e-4);
  EXPECT_NEAR(mean_over_centre(365.875), 0.7445, 1e-4);
  EXPECT_NEAR(mean_over_centre(445.125), 0.7596, 1e-4);
  EXPECT_NEAR(mean_over_centre(579.880), 0.8125, 1e-4);
  EXPECT_NEAR(mean_over_centre(869.600), 0.8701, 1e-4);
}

// Another description of the same sun: the power law of Hestroffer & Magnan 1998 (Astron. Astrophys. 333,
// 338) has I/I0 = mu^alpha, alpha = -0.023 + 0.292/λ for λ = 0.416-1.099 μm, so that the mean is 2/(2 +
// alpha).
TEST(LimbDarkening, PowerLawOfAnotherSource) {
  const LimbDarkening darkening = LimbDarkening::load(test::context);
  for (const double wavelength_nm : {450.0, 550.0, 650.0, 800.0, 1000.0}) {
    const double alpha = -0.023 + 292.0 / wavelength_nm;
    EXPECT_NEAR(1.0 / darkening.at(wavelength_nm)(1.0), 2.0 / (2.0 + alpha), 0.008) << wavelength_nm;
  }
}

TEST(LimbDarkening, MeanOfTheDiscIsOne) {
  const LimbDarkening darkening = LimbDarkening::load(test::context);
  for (double wavelength_nm = 300.0; wavelength_nm <= 1000.0; wavelength_nm += 7.0) {
    const LimbDarkeningLaw law = darkening.at(wavelength_nm);
    EXPECT_NEAR(disc_mean(law), 1.0, 1e-12);
    // Midpoints of 2000 rings of equal area: ∫ law dr².
    double mean = 0.0;
    for (int ring = 0; ring < 2000; ++ring) mean += law(std::sqrt(1.0 - (ring + 0.5) / 2000.0)) / 2000.0;
    EXPECT_NEAR(mean, 1.0, 1e-5);
  }
}

TEST(LimbDarkening, DarkerTowardsTheLimbAndMostSoInTheBlue) {
  const LimbDarkening darkening = LimbDarkening::load(test::context);
  for (const double wavelength_nm : {300.0, 400.0, 500.0, 700.0, 1000.0}) {
    const LimbDarkeningLaw law = darkening.at(wavelength_nm);
    for (double mu = 0.0; mu < 1.0; mu += 0.02)
      EXPECT_LT(law(mu), law(mu + 0.02)) << wavelength_nm << " " << mu;
  }
  EXPECT_LT(darkening.at(400.0)(0.2) / darkening.at(400.0)(1.0),
            darkening.at(700.0)(0.2) / darkening.at(700.0)(1.0));
}

}  // namespace
}  // namespace skylut
