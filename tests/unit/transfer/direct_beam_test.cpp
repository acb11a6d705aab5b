#include "skylut/transfer/direct_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"

namespace skylut {
namespace {

const Shells kEarth{{0.0, 1.0, 5.0, 20.0, 100.0}, 6371.0};

// A planet so large that layers are flat: 1/cos z above the observer, the part of his layer, 0 below.
TEST(DirectBeam, FlatLayers) {
  const Shells flat{kEarth.levels_km, 1e9};
  const auto factors = beam_path_factors(flat, 3.0, 60.0);
  ASSERT_TRUE(factors);
  EXPECT_EQ((*factors)[0], 0.0);
  EXPECT_NEAR((*factors)[1], 2.0 * 0.5, 1e-6);  // sphericity: thickness over radius, 1e-7
  EXPECT_NEAR((*factors)[2], 2.0, 1e-6);
  EXPECT_NEAR((*factors)[3], 2.0, 1e-6);
}

// By the law of cosines in one shell of 100 km: s = -R cos z + sqrt(R² cos² z + 2 R H + H²).
TEST(DirectBeam, RoundEarth) {
  const Shells one{{0.0, 100.0}, 6371.0};
  for (const double zenith_deg : {0.0, 45.0, 80.0, 89.0, 90.0}) {
    const double along = 6371.0 * std::cos(zenith_deg * kRadiansPerDegree);
    const double length = std::sqrt(along * along + 2.0 * 6371.0 * 100.0 + 100.0 * 100.0) - along;
    EXPECT_NEAR(beam_path_factors(one, 0.0, zenith_deg)->front(), length / 100.0, 1e-9) << zenith_deg;
  }
}

// At 20 km the horizon dips acos(6371/6391) = 4.53 deg: a sun 4 deg below the horizontal shines from below
// through air that it crosses twice; one 5 deg below does not.
TEST(DirectBeam, SunBelowTheHorizontal) {
  const auto above = beam_path_factors(kEarth, 20.0, 90.0);
  const auto below = beam_path_factors(kEarth, 20.0, 94.0);
  ASSERT_TRUE(above && below);
  EXPECT_EQ((*above)[2], 0.0);
  EXPECT_GT((*below)[2], 30.0);
  EXPECT_FALSE(beam_path_factors(kEarth, 20.0, 95.0));
  EXPECT_FALSE(beam_path_factors(kEarth, 20.0, 180.0));
  EXPECT_FALSE(beam_path_factors(kEarth, 0.0, 90.001));
  EXPECT_TRUE(beam_path_factors(kEarth, 0.0, 90.0));
}

TEST(DirectBeam, BeerLambert) {
  EXPECT_DOUBLE_EQ(beam_transmittance({2.0, 3.0}, {0.1, 0.2}), std::exp(-0.8));
  EXPECT_DOUBLE_EQ(beam_transmittance({0.0, 0.0}, {5.0, 5.0}), 1.0);
}

TEST(DirectBeam, WrongUseIsRefused) {
  EXPECT_THROW(beam_path_factors(kEarth, -0.1, 0.0), InputError);
  EXPECT_THROW(beam_path_factors(kEarth, 100.1, 0.0), InputError);
  EXPECT_THROW(beam_path_factors(kEarth, 0.0, 180.1), InputError);
  EXPECT_THROW(beam_path_factors(kEarth, 0.0, NAN), InputError);
  EXPECT_THROW(beam_path_factors({{0.0}, 6371.0}, 0.0, 0.0), InputError);
  EXPECT_THROW(beam_transmittance({1.0}, {0.1, 0.2}), InputError);
}

}  // namespace
}  // namespace skylut
