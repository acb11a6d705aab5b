#include "skylut/atmosphere/ground_albedo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/atmosphere/atmosphere.hpp"
#include "skylut/core/errors.hpp"
#include "support/test_context.hpp"

namespace skylut {
namespace {

TEST(GroundAlbedo, ANumberIsTheSameEverywhere) {
  const GroundAlbedo ground = 0.3;
  EXPECT_EQ(ground.at(300.0), 0.3);
  EXPECT_EQ(ground.at(1000.0, 20.0), 0.3);
  EXPECT_EQ(ground.constant(), 0.3);
  EXPECT_EQ(ground.text(), "0.3");
  EXPECT_THROW(GroundAlbedo(1.1).validate(), InputError);
  EXPECT_THROW(GroundAlbedo(NAN).validate(), InputError);
}

// What everyone knows of them: snow is white, grass has its red edge, sand is reddish, water and asphalt
// dark.
TEST(GroundAlbedo, PresetsLookLikeTheirNames) {
  EXPECT_EQ(GroundAlbedo::names(test::context),
            (std::vector<std::string>{"asphalt", "grass", "sand", "snow", "water"}));
  for (const std::string& name : GroundAlbedo::names(test::context)) {
    const GroundAlbedo ground = GroundAlbedo::load(test::context, name);
    ground.validate();
    EXPECT_FALSE(ground.constant());
    EXPECT_EQ(ground.name(), name);
    for (double wavelength_nm = 300.0; wavelength_nm <= 1000.0; wavelength_nm += 5.0)
      EXPECT_GT(ground.at(wavelength_nm, 5.0), 0.0) << name;
  }
  EXPECT_GT(GroundAlbedo::load(test::context, "snow").at(500.0), 0.95);
  EXPECT_LT(GroundAlbedo::load(test::context, "snow").at(1000.0), 0.75);
  const GroundAlbedo grass = GroundAlbedo::load(test::context, "grass");
  EXPECT_GT(grass.at(550.0), 1.5 * grass.at(675.0));
  EXPECT_GT(grass.at(800.0), 8.0 * grass.at(675.0));
  EXPECT_GT(GroundAlbedo::load(test::context, "sand").at(700.0),
            2.0 * GroundAlbedo::load(test::context, "sand").at(400.0));
  EXPECT_LT(GroundAlbedo::load(test::context, "water").at(550.0), 0.1);
  EXPECT_LT(GroundAlbedo::load(test::context, "asphalt").at(550.0), 0.15);
}

// Snow as its file's header computes it: Warren and Brandt's k = 2.289e-9 at 550 nm, grains of 0.2 mm.
TEST(GroundAlbedo, SnowFollowsItsFormula) {
  const double n = 1.31;
  const double k = 2.289e-9;
  const double g = 0.885;
  const double absorbed =
      8.0 * M_PI * 200e-6 * k / (3.0 * 550e-9) * (n * n * n - std::pow(n * n - 1.0, 1.5)) / n;
  const double expected = std::exp(-4.0 * std::sqrt(absorbed / (3.0 * (1.0 - g * (1.0 - absorbed)))));
  EXPECT_NEAR(GroundAlbedo::load(test::context, "snow").at(550.0), expected,
              6e-4);  // the file has three decimals
}

TEST(GroundAlbedo, BandMeansAndEnds) {
  const GroundAlbedo ground("mine", SpectralCurve::through_points({400.0, 500.0, 700.0}, {0.0, 1.0, 1.0}));
  EXPECT_DOUBLE_EQ(ground.at(450.0, 10.0), 0.5);
  EXPECT_DOUBLE_EQ(ground.at(500.0, 100.0), 0.5 * (0.75 + 1.0));
  EXPECT_DOUBLE_EQ(ground.at(400.0, 10.0), 0.025);  // only 400-405 nm are known
  EXPECT_DOUBLE_EQ(ground.at(700.0, 10.0), 1.0);
  EXPECT_THROW(ground.at(399.0, 10.0), InputError);
}

TEST(GroundAlbedo, AirHandsItToTheSolver) {
  AtmosphereOptions options;
  options.ground_albedo = GroundAlbedo::load(test::context, "grass");
  const Atmosphere air(test::context, load_profile(test::context, "ussa1976"), options);
  EXPECT_EQ(air.column(550.0, 0.1).ground_albedo, options.ground_albedo.at(550.0));
  for (const BandColumn& term : air.band_columns({710.0, 20.0}, 0.1))
    EXPECT_EQ(term.column.ground_albedo, options.ground_albedo.at(710.0, 20.0));
}

TEST(GroundAlbedo, WrongNamesAreRefused) {
  EXPECT_THROW(GroundAlbedo::load(test::context, "gras"), InputError);
  EXPECT_THROW(GroundAlbedo::load(test::context, "missing.csv"), InputError);
}

}  // namespace
}  // namespace skylut
