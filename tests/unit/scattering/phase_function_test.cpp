#include "skylut/scattering/phase_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

double legendre(int l, double x) {
  double previous = 1.0;
  double value = x;
  if (l == 0) return 1.0;
  for (int k = 2; k <= l; ++k) {
    const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k;
    previous = value;
    value = next;
  }
  return value;
}

// ½∫ p P_l dcosΘ by Gauss-Legendre: 200 nodes resolve Henyey-Greenstein of g = 0.85 to round-off.
double integrated_moment(const PhaseFunction& phase, int l) {
  static const Quadrature rule = gauss_legendre(200, -1.0, 1.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.node.size(); ++i)
    sum += 0.5 * rule.weight[i] * phase.value(rule.node[i]) * legendre(l, rule.node[i]);
  return sum;
}

TEST(PhaseFunction, NormalisedWithTheStatedMoments) {
  const RayleighPhaseFunction dipole;
  const RayleighPhaseFunction air(0.0279);
  const HenyeyGreensteinPhaseFunction isotropic(0.0);
  const HenyeyGreensteinPhaseFunction forward(0.85);
  const HenyeyGreensteinPhaseFunction backward(-0.3);
  const LegendrePhaseFunction series({1.0, 0.6, 0.3, 0.1});
  for (const PhaseFunction* phase :
       std::initializer_list<const PhaseFunction*>{&dipole, &air, &isotropic, &forward, &backward, &series})
    for (int l = 0; l <= 20; ++l) EXPECT_NEAR(integrated_moment(*phase, l), phase->moment(l), 1e-12) << l;
}

// Forward, sideways and backward: closed forms.
TEST(PhaseFunction, ValuesAtTheEnds) {
  const RayleighPhaseFunction dipole;
  EXPECT_DOUBLE_EQ(dipole.value(1.0), 1.5);
  EXPECT_DOUBLE_EQ(dipole.value(-1.0), 1.5);
  EXPECT_DOUBLE_EQ(dipole.value(0.0), 0.75);
  // p(90°)/p(0°) = (1 + 3γ)/(2 + 2γ), γ = ρ/(2-ρ): with (1+ρ)/2 in terms of ρ.
  const double rho = 0.0279;
  const RayleighPhaseFunction air(rho);
  EXPECT_NEAR(air.value(0.0) / air.value(1.0), (1.0 + rho) / 2.0, 1e-14);
  EXPECT_DOUBLE_EQ(air.value(1.0), air.value(-1.0));
  const double g = 0.7;
  const HenyeyGreensteinPhaseFunction haze(g);
  EXPECT_NEAR(haze.value(1.0), (1.0 + g) / std::pow(1.0 - g, 2), 1e-11);
  EXPECT_NEAR(haze.value(-1.0), (1.0 - g) / std::pow(1.0 + g, 2), 1e-15);
  const LegendrePhaseFunction series({1.0, 0.6, 0.3, 0.1});
  EXPECT_NEAR(series.value(1.0), 1.0 + 1.8 + 1.5 + 0.7, 1e-14);
  EXPECT_NEAR(series.value(-1.0), 1.0 - 1.8 + 1.5 - 0.7, 1e-14);
}

TEST(PhaseFunction, ALongSeriesIsTheClosedForm) {
  const double g = 0.6;
  std::vector<double> moments;
  for (int l = 0; l < 80; ++l) moments.push_back(std::pow(g, l));
  const LegendrePhaseFunction series(moments);
  const HenyeyGreensteinPhaseFunction closed(g);
  for (double cosine : {-1.0, -0.4, 0.0, 0.5, 0.99, 1.0})
    EXPECT_NEAR(series.value(cosine), closed.value(cosine), 1e-12 * 80 * closed.value(1.0)) << cosine;
  EXPECT_EQ(series.moment(80), 0.0);
}

// What the base class integrates of a matrix is what Rayleigh's law has in closed form.
class RayleighByQuadrature final : public PhaseFunction {
 public:
  double value(double cosine) const override { return air_.value(cosine); }
  double moment(int l) const override { return air_.moment(l); }
  ScatteringMatrix matrix(double cosine) const override { return air_.matrix(cosine); }

 private:
  RayleighPhaseFunction air_{0.03};
};

TEST(PhaseFunction, MomentsOfTheRayleighMatrix) {
  const std::vector<MatrixMoments> closed = RayleighPhaseFunction(0.03).matrix_moments(6);
  const std::vector<MatrixMoments> integrated = RayleighByQuadrature().matrix_moments(6);
  for (std::size_t l = 0; l < closed.size(); ++l) {
    EXPECT_NEAR(integrated[l].alpha1, closed[l].alpha1, 1e-13);
    EXPECT_NEAR(integrated[l].alpha2, closed[l].alpha2, 1e-13);
    EXPECT_NEAR(integrated[l].alpha3, closed[l].alpha3, 1e-13);
    EXPECT_NEAR(integrated[l].beta1, closed[l].beta1, 1e-13);
  }
}

// Light scattered at 90 degrees by dipoles is polarised altogether, by air less.
TEST(PhaseFunction, RayleighPolarises) {
  const ScatteringMatrix dipole = RayleighPhaseFunction().matrix(0.0);
  EXPECT_NEAR(-dipole.f12 / dipole.f11, 1.0, 1e-15);
  const ScatteringMatrix air = RayleighPhaseFunction(0.0279).matrix(0.0);
  EXPECT_NEAR(-air.f12 / air.f11, (1.0 - 0.0279) / (1.0 + 0.0279), 1e-12);
}

// A peak hands on the polarisation of what it does not turn.
TEST(PhaseFunction, APeakKeepsPolarisation) {
  constexpr double kAsymmetry = 0.95;  // what is turned at all is of the order of 1 - g
  const std::vector<MatrixMoments> peak = HenyeyGreensteinPhaseFunction(kAsymmetry).matrix_moments(12);
  for (std::size_t l = 2; l < peak.size(); ++l) {
    EXPECT_NEAR(peak[l].alpha2, peak[l].alpha1, 1.0 - kAsymmetry);
    EXPECT_NEAR(peak[l].alpha3, peak[l].alpha2, 1e-12);
    EXPECT_EQ(peak[l].beta1, 0.0);
  }
}

TEST(PhaseFunction, OutOfRangeIsRefused) {
  EXPECT_THROW(RayleighPhaseFunction(-0.1), InputError);
  EXPECT_THROW(RayleighPhaseFunction(0.6), InputError);
  EXPECT_THROW(HenyeyGreensteinPhaseFunction(1.0), InputError);
  EXPECT_THROW(HenyeyGreensteinPhaseFunction(NAN), InputError);
  EXPECT_THROW(LegendrePhaseFunction({}), InputError);
  EXPECT_THROW(LegendrePhaseFunction({0.9}), InputError);
  EXPECT_THROW(LegendrePhaseFunction({1.0, 1.2}), InputError);
}

}  // namespace
}  // namespace skylut
