#pragma once

#include <cmath>

#include "linear_form.hpp"

namespace skylut::fit_detail {

/// The constant term of the linear form, p = 1 - c k₁ - e k₂ with k₁ = e^{D(θ_s-γ₀)}/D and k₂ = cos²θ_s: the
/// inverse of 1 + C e^{Dθ_s} + E cos²θ_s. Where it vanishes C and E are infinite. [fit.md F3]
struct ZenithOffset {
  double k1, k2, k1_D;

  ZenithOffset(double D, const SunFrame& sun) {
    const double t0 = sun.sun_zenith_rad - sun.gamma_0_rad;
    k1 = std::exp(D * t0) / D;
    k2 = sun.cos2_sun_zenith;
    k1_D = k1 * (t0 - 1.0 / D);
  }

  double at(double c, double e) const { return 1.0 - c * k1 - e * k2; }

  /// The line of all c, e that have one p, and how it moves with D.
  struct Line {
    double c, e, c_along, e_along;
    double c_D, e_D, c_along_D, e_along_D;
  };
  Line line(double p) const {
    const double square = k1 * k1 + k2 * k2;
    const double foot = (1.0 - p) / square;
    const double foot_D = -2.0 * foot * k1 * k1_D / square;
    return {k1 * foot, k2 * foot, -k2, k1, k1_D * foot + k1 * foot_D, k2 * foot_D, 0.0, k1_D};
  }
};

}  // namespace skylut::fit_detail
