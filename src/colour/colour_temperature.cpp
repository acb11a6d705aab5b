#include "skylut/colour/colour_temperature.hpp"

#include <cmath>

namespace skylut {

namespace {

constexpr double kSecondRadiationConstant_nm_K = 1.4388e7;
constexpr double kFurthest_uv = 0.05;

// The locus is walked by the reciprocal temperature, along which chromaticity moves evenly; per MK (mired).
constexpr double kHottest_per_MK = 10.0;
constexpr double kColdest_per_MK = 1000.0;
constexpr double kStep_per_MK = 5.0;

}  // namespace

PlanckianLocus::PlanckianLocus(const ColourMatching& matching)
    : wavelength_nm_(matching.wavelengths_nm()), observer_(matching.values()) {}

Yxy PlanckianLocus::chromaticity(double temperature_K) const {
  Xyz sum;
  for (std::size_t i = 0; i < wavelength_nm_.size(); ++i) {
    const double lambda = wavelength_nm_[i];
    // Against its value at 560 nm, so that cold bodies do not underflow.
    const double exponent = kSecondRadiationConstant_nm_K / temperature_K;
    const double radiance =
        std::pow(560.0 / lambda, 5) * std::expm1(exponent / 560.0) / std::expm1(exponent / lambda);
    sum.X += radiance * observer_[i].X;
    sum.Y += radiance * observer_[i].Y;
    sum.Z += radiance * observer_[i].Z;
  }
  return to_yxy(sum);
}

// CIE 1960 (CIE 15:2004): u = 4x / (-2x + 12y + 3), v = 6y / (-2x + 12y + 3).
PlanckianLocus::Uv PlanckianLocus::uv(const Yxy& light) {
  const double denominator = -2.0 * light.x + 12.0 * light.y + 3.0;
  return {4.0 * light.x / denominator, 6.0 * light.y / denominator};
}

double PlanckianLocus::distance(const Uv& light, double per_megakelvin) const {
  const Uv body = uv(chromaticity(1e6 / per_megakelvin));
  return std::hypot(light.u - body.u, light.v - body.v);
}

std::optional<ColourTemperature> PlanckianLocus::nearest(const Yxy& light) const {
  const Uv point = uv(light);
  const double first = kHottest_per_MK - kStep_per_MK;
  double near = first;
  double nearest = distance(point, first);
  for (double at = kHottest_per_MK; at <= kColdest_per_MK + kStep_per_MK; at += kStep_per_MK)
    if (const double away = distance(point, at); away < nearest) {
      near = at;
      nearest = away;
    }
  if (near == first) return std::nullopt;

  // Golden section between the neighbours: the distance has one minimum there.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double lower = near - kStep_per_MK;
  double upper = near + kStep_per_MK;
  while (upper - lower > 1e-6 * lower) {
    const double low = upper - golden * (upper - lower);
    const double high = lower + golden * (upper - lower);
    if (distance(point, low) < distance(point, high))
      upper = high;
    else
      lower = low;
  }
  const double per_megakelvin = 0.5 * (lower + upper);
  const double away = distance(point, per_megakelvin);
  const bool in_range = per_megakelvin >= kHottest_per_MK && per_megakelvin <= kColdest_per_MK;
  if (!in_range || !(away <= kFurthest_uv)) return std::nullopt;
  const double temperature_K = 1e6 / per_megakelvin;
  const bool above = point.v > uv(chromaticity(temperature_K)).v;
  return ColourTemperature{temperature_K, above ? away : -away};
}

}  // namespace skylut
