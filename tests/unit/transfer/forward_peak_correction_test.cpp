#include "spherical/forward_peak_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "skylut/core/legendre.hpp"

namespace skylut::transfer {
namespace {

/// Phase function of the peak's part with its scatterings counted once each, from the exponential itself.
double counted_once(const PhaseFunction& phase, int max_l, double m, double x) {
  const double peak = phase.moment(max_l + 1);
  double sum = 0.0;
  for (int l = 0; l < 400; ++l) {
    const double p = l <= max_l ? 1.0 : phase.moment(l) / peak;
    const double factor = p > 1e-9 ? std::exp(-m) * std::expm1(m * p) / (m * p) : std::exp(-m);
    sum += (2.0 * l + 1.0) * peak * p * factor * std::legendre(static_cast<unsigned>(l), x);
  }
  return sum;
}

double uncorrected(const PhaseFunction& phase, int max_l, double x) {
  const double peak = phase.moment(max_l + 1);
  double sum = 0.0;
  for (int l = 0; l < 400; ++l)
    sum +=
        (2.0 * l + 1.0) * (l <= max_l ? peak : phase.moment(l)) * std::legendre(static_cast<unsigned>(l), x);
  return sum;
}

// Two orders of the series in m: what is left is of third order, m³/6 of the peak's part at most.
TEST(ForwardPeakCorrection, IsTheSeriesOfScatteringsCountedOnce) {
  const HenyeyGreensteinPhaseFunction phase(0.85);
  constexpr int kMaxL = 14;
  const ForwardPeakCorrection spread(phase, kMaxL);
  for (const double degrees : {0.0, 2.0, 5.0, 10.0, 20.0, 60.0}) {
    const double x = std::cos(degrees * std::acos(-1.0) / 180.0);
    const auto [first, second] = spread.at(normalised_legendre(0, static_cast<int>(spread.terms()) - 1, x));
    const double whole = uncorrected(phase, kMaxL, x);
    const double largest = uncorrected(phase, kMaxL, 1.0);
    for (const double m : {0.01, 0.1, 0.3}) {
      const double exact = counted_once(phase, kMaxL, m, x);
      // The sum ends where a moment g^l has fallen to 0.2 % of the peak; the geometric rest, (2l+1) g^l/(1-g)
      // with l = 53, is 2.8e-3 of the sum.
      const double left_out = 3e-3 * m * largest;
      EXPECT_NEAR(whole - m * first + 0.5 * m * m * second, exact, m * m * m / 6.0 * largest + left_out)
          << degrees << " " << m;
    }
  }
}

// Light is neither made nor lost twice: of the peak's light, half of m is taken back (k scatterings were
// counted k times), and that without regard to direction, since p_0 = 1.
TEST(ForwardPeakCorrection, TakesBackWhatWasCountedTwice) {
  const HenyeyGreensteinPhaseFunction phase(0.8);
  constexpr int kMaxL = 10;
  const ForwardPeakCorrection spread(phase, kMaxL);
  double mean = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i)
    mean +=
        spread
            .at(normalised_legendre(0, static_cast<int>(spread.terms()) - 1, -1.0 + (i + 0.5) * 2.0 / kSteps))
            .first /
        kSteps;
  EXPECT_NEAR(mean, 0.5 * phase.moment(kMaxL + 1), 1e-4);
}

TEST(ForwardPeakCorrection, NothingToSpreadWithoutAPeak) {
  const auto [first, second] = ForwardPeakCorrection(RayleighPhaseFunction(), 2).at({});
  EXPECT_EQ(first, 0.0);
  EXPECT_EQ(second, 0.0);
}

}  // namespace
}  // namespace skylut::transfer
