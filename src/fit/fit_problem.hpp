#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "linear_form.hpp"
#include "skylut/fit/fit_perez.hpp"

namespace skylut::fit_detail {

/// One residual: r = model_scale · F(θ,γ)/F(0,θ_s) - target.
struct Observation {
  double secant_excess = 0.0;  ///< 1/cosθ - 1, infinity at the horizon
  double gamma_rad = 0.0;
  double cos2_excess = 0.0;  ///< K = cos²γ - cos²θ_s
  double model_scale = 0.0;
  double target = 0.0;
};

/// A fit as its solvers see it: checked, in an order that does not depend on the order of the samples, equal
/// samples merged (the mirror halves of a sky), weights scaled to mean 1.
struct FitProblem {
  SunFrame sun;
  std::vector<Observation> observations;  // by ascending zenith angle
  std::vector<std::size_t> ring_begins;   // first observation of each zenith angle, and one past the last
  std::size_t samples = 0;                ///< of weight > 0, before merging
  /// Whether some zenith angle is seen at more than one angle to the sun. If not (sun at the zenith, a scan
  /// along a meridian), γ is a function of θ, and nothing but the shape of the formula tells its two factors
  /// apart.
  bool separable = false;
};

/// @throws InputError  as fit_perez does
FitProblem make_fit_problem(std::span<const SkySample> samples, double sun_zenith_rad, double zenith_value,
                            ResidualKind residual);

}  // namespace skylut::fit_detail
