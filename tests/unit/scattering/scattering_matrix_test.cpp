#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/scattering/legendre_scattering_matrix.hpp"
#include "skylut/scattering/tabulated_scattering_matrix.hpp"

namespace skylut {
namespace {

/// Rayleigh's matrix every so many degrees.
ScatteringTable rayleigh_table(double depolarisation, int step_deg) {
  const RayleighPhaseFunction air(depolarisation);
  ScatteringTable table;
  for (int degree = 0; degree <= 180; degree += step_deg) {
    const ScatteringMatrix at = air.matrix(std::cos(degree * kRadiansPerDegree));
    table.theta_deg.push_back(degree);
    table.f11.push_back(at.f11);
    table.f12.push_back(at.f12);
    table.f22.push_back(at.f22);
    table.f33.push_back(at.f33);
  }
  return table;
}

// Lagrange's cubic over steps of 2° errs by some (2π/90)⁴/40 of the curves: 6e-7.
TEST(ScatteringMatrices, TableHasTheMomentsOfItsCurve) {
  const TabulatedScatteringMatrix table(rayleigh_table(0.03, 2));
  const RayleighPhaseFunction air(0.03);
  const std::vector<MatrixMoments> expected = air.matrix_moments(8);
  const std::vector<MatrixMoments> moments = table.matrix_moments(8);
  for (std::size_t l = 0; l < moments.size(); ++l) {
    EXPECT_NEAR(moments[l].alpha1, expected[l].alpha1, 1e-6) << l;
    EXPECT_NEAR(moments[l].alpha2, expected[l].alpha2, 1e-6) << l;
    EXPECT_NEAR(moments[l].alpha3, expected[l].alpha3, 1e-6) << l;
    EXPECT_NEAR(moments[l].beta1, expected[l].beta1, 1e-6) << l;
    EXPECT_EQ(table.moment(static_cast<int>(l)), moments[l].alpha1);
  }
  for (double mu : {-1.0, -0.73, 0.004, 0.999, 1.0}) {
    EXPECT_NEAR(table.value(mu), air.value(mu), 3e-6) << mu;
    EXPECT_NEAR(table.matrix(mu).f12, air.matrix(mu).f12, 3e-6) << mu;
    EXPECT_NEAR(table.matrix(mu).f33, air.matrix(mu).f33, 3e-6) << mu;
  }
  EXPECT_EQ(table.moment(100'000), 0.0);
}

// Moments and series are each other's inverse.
TEST(ScatteringMatrices, SeriesGivesBackItsMoments) {
  const HenyeyGreensteinPhaseFunction haze(0.5);
  constexpr int kLast = 60;
  const LegendreScatteringMatrix series(haze.matrix_moments(kLast));
  for (double mu : {-1.0, -0.4, 0.3, 0.95}) {
    EXPECT_NEAR(series.value(mu), haze.value(mu), 1e-12);
    EXPECT_NEAR(series.matrix(mu).f12, 0.0, 1e-12);
    EXPECT_NEAR(series.matrix(mu).f22, haze.matrix(mu).f22, 1e-10);
    EXPECT_NEAR(series.matrix(mu).f33, haze.matrix(mu).f33, 1e-10);
  }
  EXPECT_EQ(series.matrix_moments(100).size(), 101U);
  EXPECT_EQ(series.moment(61), 0.0);
}

TEST(ScatteringMatrices, RefuseWhatIsNone) {
  ScatteringTable short_table = rayleigh_table(0.0, 90);
  EXPECT_THROW(TabulatedScatteringMatrix{short_table}, InputError);
  using Moments = std::vector<MatrixMoments>;
  EXPECT_THROW(LegendreScatteringMatrix(Moments{}), InputError);
  EXPECT_THROW(LegendreScatteringMatrix(Moments{{.alpha1 = 0.9}}), InputError);
  EXPECT_THROW(LegendreScatteringMatrix(Moments{{.alpha1 = 1.0}, {}, {.beta1 = 1.5}}), InputError);
}

}  // namespace
}  // namespace skylut
