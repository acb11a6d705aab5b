#pragma once

#include <Eigen/Core>
#include <cmath>

#include "linear_form.hpp"

namespace skylut::fit_detail {

/// The aureole's basis W of all observations at once, and its derivative by D: aureole_basis() in a form that
/// a vector unit computes, the same to 1e-12.
struct Aureole {
  Eigen::ArrayXd W;
  Eigen::ArrayXd W_D;

  explicit Aureole(Eigen::Index observations)
      : W(observations), W_D(observations), x_(observations), ratio_(observations) {}

  /// @param away  γ - θ_s of every observation
  void set(double D, const Eigen::ArrayXd& away, const SunFrame& sun, bool derivative = false) {
    // (e^x - 1)/x and its derivative; below the threshold their series, the rest of which is below 1e-15.
    constexpr double kSmall = 1e-3;
    const double t0 = sun.sun_zenith_rad - sun.gamma_0_rad;
    const double level = std::exp(D * t0);
    x_ = D * away;
    W = x_.exp();
    ratio_ = (W - 1.0) / x_;
    if (derivative) W_D = (W - ratio_) / x_;
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      const double x = x_(i);
      if (std::abs(x) > kSmall) continue;
      ratio_(i) = 1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0)));
      if (derivative) W_D(i) = 0.5 + x / 3.0 + x * x / 8.0 + x * x * x / 30.0 + x * x * x * x / 144.0;
    }
    W = level * away * ratio_;
    if (derivative) W_D = t0 * W + level * away.square() * W_D;
  }

 private:
  Eigen::ArrayXd x_;
  Eigen::ArrayXd ratio_;
};

}  // namespace skylut::fit_detail
