#include "skylut/scattering/mie_sphere.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "skylut/core/constants.hpp"
#include "skylut/core/errors.hpp"
#include "skylut/core/quadrature.hpp"

namespace skylut {
namespace {

using Complex = std::complex<double>;

struct Case {
  double x;
  Complex m;
  double q_ext;
  double q_sca;
  double asymmetry;
};

// Wiscombe 1979, NCAR/TN-140+STR, appendix: test cases 7-8, 10, 12-19. Printed with six decimals.
TEST(MieSphere, WiscombeTestCases) {
  const std::vector<Case> cases{{10.0, {0.75, 0.0}, 2.232265, 2.232265, 0.896473},
                                {1000.0, {0.75, 0.0}, 1.997908, 1.997908, 0.844944},
                                {100.0, {1.33, 1e-5}, 2.101321, 2.096594, 0.868959},
                                {0.055, {1.5, 1.0}, 0.101491, 0.000011, 0.000491},
                                {0.056, {1.5, 1.0}, 0.103347, 0.000012, 0.000509},
                                {1.0, {1.5, 1.0}, 2.336321, 0.663454, 0.192136},
                                {100.0, {1.5, 1.0}, 2.097502, 1.283697, 0.850252},
                                {1e4, {1.5, 1.0}, 2.004368, 1.236574, 0.846310},
                                {1.0, {10.0, 10.0}, 2.532993, 2.049405, -0.110664},
                                {100.0, {10.0, 10.0}, 2.071124, 1.836785, 0.556215},
                                {1e4, {10.0, 10.0}, 2.005914, 1.795393, 0.548194}};
  constexpr double kPrinted = 1.01e-6;  // the last case of each index is rounded differently by a unit
  for (const Case& c : cases) {
    const MieSphere sphere(c.x, c.m);
    EXPECT_NEAR(sphere.q_ext(), c.q_ext, kPrinted) << c.x << " " << c.m;
    EXPECT_NEAR(sphere.q_sca(), c.q_sca, kPrinted) << c.x << " " << c.m;
    EXPECT_NEAR(sphere.asymmetry(), c.asymmetry, kPrinted) << c.x << " " << c.m;
  }
}

// Bohren and Huffman 1983, appendix A: radius 0.525 µm, 632.8 nm, index 1.55.
TEST(MieSphere, BohrenAndHuffmanExample) {
  const MieSphere sphere(2.0 * kPi * 0.525 / 0.6328, 1.55);
  EXPECT_NEAR(sphere.q_ext(), 3.10543, 5e-6);
  EXPECT_NEAR(sphere.q_sca(), 3.10543, 5e-6);
  EXPECT_NEAR(sphere.asymmetry(), 0.63314, 5e-6);
  const MieSphere::Amplitudes back = sphere.amplitudes(-1.0);
  EXPECT_NEAR(4.0 * std::norm(back.s1) / std::pow(sphere.size_parameter(), 2), 2.92534, 5e-6);
}

// S11 = (|S1|² + |S2|²)/2 of Wiscombe's test case 15 (MIEV0), six digits: a unit of the last. Angles between
// 0 and 10 degrees are left out: their cosines were in single precision, which moves S11 by up to 3e-4 there.
TEST(MieSphere, WiscombeIntensities) {
  const MieSphere sphere(100.0, {1.5, 1.0});
  const std::vector<std::array<double, 2>> published{{0.0, 2.75830e7}, {10.0, 1.39151e4}, {30.0, 1208.65},
                                                     {60.0, 606.236},  {90.0, 474.503},   {120.0, 438.391},
                                                     {150.0, 431.440}};
  for (const auto& [angle_deg, s11] : published) {
    const MieSphere::Amplitudes at = sphere.amplitudes(std::cos(angle_deg * kRadiansPerDegree));
    EXPECT_NEAR(0.5 * (std::norm(at.s1) + std::norm(at.s2)) / s11, 1.0, 1e-5) << angle_deg;
  }
}

// Our own calculation with mpmath (60-1000 digits, all recurrences upward): phase function at 0, 30, 90,
// 180°.
TEST(MieSphere, ExtendedPrecision) {
  struct Reference {
    Case sphere;
    std::array<double, 4> phase;
  };
  const std::vector<Reference> references{
      {{0.001, {1.33, 0}, 1.10988809524e-13, 1.10988809524e-13, 1.83277824301e-7},
       {1.50000066513, 1.31250051361, 0.75, 1.49999933487}},
      {{0.03, {1.5, 0.01}, 0.000598410649541, 1.86940256017e-7, 0.000178484033293},
       {1.50063750146, 1.31299686999, 0.749999976651, 1.49936262208}},
      {{0.3, {1.2, 0.5}, 0.38008473833, 0.00268241742992, 0.0148196134155},
       {1.5553579551, 1.3546382116, 0.749828177312, 1.44564202489}},
      {{2, {1.9, 0}, 3.85731063438, 3.85731063438, 0.510247214656},
       {5.18540527324, 3.39415168419, 0.528595090246, 0.210080791818}},
      {{5, {1.75, 0.44}, 2.58720867942, 1.22445784277, 0.846977552059},
       {34.348835349, 1.93834854018, 0.109083353291, 0.0522145499898}},
      {{20, {1.33, 1e-08}, 2.14010707337, 2.14010609575, 0.769126808916},
       {224.332508857, 0.883356613198, 0.176679345055, 1.12099398324}},
      {{60, {1.53, 0.008}, 2.10515377392, 1.28529062779, 0.913289302867},
       {3121.00478973, 0.815756199991, 0.0669128185874, 0.0184851488245}},
      {{150, {1.2, 0}, 2.08456390294, 2.08456390294, 0.923584363429},
       {11725.6896103, 2.5565295527, 0.017418913493, 0.516770433894}},
      {{300, {1.9, 0.1}, 2.04406732542, 1.1736965728, 0.905222561534},
       {80163.3616463, 0.26705214044, 0.093082000622, 0.0829750846503}},
      {{500, {1.45, 0.5}, 2.0308945989, 1.15382433912, 0.922530243443},
       {223526.605386, 0.28304865694, 0.0760292086473, 0.0627228511514}},
      {{500, {1.5, 0}, 2.04264632278, 2.04264632278, 0.825397525991},
       {127711.488225, 1.40282326459, 0.0827082424828, 0.418703533008}},
      {{3000, {1.33, 0.0001}, 2.00860862533, 1.39910704457, 0.936387231536},
       {6488557.73936, 1.18618371579, 0.0194555213296, 0.0238275067137}}};
  for (const auto& [c, phase] : references) {
    const MieSphere sphere(c.x, c.m);
    EXPECT_NEAR(sphere.q_ext() / c.q_ext, 1.0, 1e-11) << c.x;  // twelve digits are given
    EXPECT_NEAR(sphere.q_sca() / c.q_sca, 1.0, 1e-11) << c.x;
    // g of a small sphere is a difference of terms x⁻² as large: round-off.
    EXPECT_NEAR(sphere.asymmetry() / c.asymmetry, 1.0, c.x < 0.01 ? 1e-7 : 1e-10) << c.x;
    for (std::size_t i = 0; i < 4; ++i) {
      const double mu = std::array{1.0, std::sqrt(0.75), 0.0, -1.0}[i];
      // Thousands of terms nearly cancel in the light scattered back by large spheres: round-off.
      EXPECT_NEAR(sphere.phase_function(mu) / phase[i], 1.0, 3e-9) << c.x << " " << mu;
    }
  }
}

// Small spheres scatter as Rayleigh says, absorb as x, and conserve energy without absorption.
TEST(MieSphere, RayleighLimit) {
  const Complex m(1.5, 0.01);
  const Complex polarisability = (m * m - 1.0) / (m * m + 2.0);
  const double x = 1e-3;
  const MieSphere sphere(x, m);
  // Next order: x² relative.
  EXPECT_NEAR(sphere.q_sca() / (8.0 / 3.0 * std::pow(x, 4) * std::norm(polarisability)), 1.0, 2e-6);
  EXPECT_NEAR((sphere.q_ext() - sphere.q_sca()) / (4.0 * x * polarisability.imag()), 1.0, 2e-6);
  for (const double size : {0.03, 1.0, 50.0, 2000.0}) {
    const MieSphere glass(size, 1.5);
    EXPECT_NEAR(glass.q_ext() / glass.q_sca(), 1.0, 1e-12);
  }
}

// Sum rules: ½∫p dμ = 1 and ½∫p μ dμ = g, by a rule that is exact for the series' degree; and the optical
// theorem, Q_ext = 4/x² Re S(0).
TEST(MieSphere, SumRules) {
  for (const auto& [x, m] : std::vector<std::pair<double, Complex>>{
           {0.03, {1.5, 0.0}}, {3.0, {1.33, 0.1}}, {40.0, {1.9, 0.0}}, {500.0, {1.5, 0.01}}}) {
    const MieSphere sphere(x, m);
    const Quadrature rule = gauss_legendre(MieSphere::terms(x) + 2, -1.0, 1.0);
    double energy = 0.0;
    double forward = 0.0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const double p = 0.5 * rule.weight[i] * sphere.phase_function(rule.node[i]);
      energy += p;
      forward += p * rule.node[i];
    }
    EXPECT_NEAR(energy, 1.0, 1e-11);
    EXPECT_NEAR(forward, sphere.asymmetry(), 1e-11);
    EXPECT_NEAR(4.0 / (x * x) * sphere.amplitudes(1.0).s1.real() / sphere.q_ext(), 1.0, 1e-11);
    EXPECT_NEAR(std::abs(sphere.amplitudes(1.0).s1 - sphere.amplitudes(1.0).s2), 0.0, 1e-9 * x * x);
  }
}

TEST(MieSphere, OutOfRangeIsRefused) {
  EXPECT_THROW(MieSphere(0.0, 1.5), InputError);
  EXPECT_THROW(MieSphere(std::nan(""), 1.5), InputError);
  EXPECT_THROW(MieSphere(1e6, 1.5), InputError);
  EXPECT_THROW(MieSphere(1.0, {1.5, -0.1}), InputError);
  EXPECT_THROW(MieSphere(1.0, {0.0, 1.0}), InputError);
  EXPECT_THROW(MieSphere(1.0, 1.0), InputError);
}

}  // namespace
}  // namespace skylut
