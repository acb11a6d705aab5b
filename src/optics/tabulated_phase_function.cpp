#include "skylut/optics/tabulated_phase_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "skylut/core/constants.hpp"

namespace skylut {

namespace {

// The grid is equally spaced in u = a ln(1 + θ/θ0) + b θ: 0.01 degrees at 0, 0.05 at 1, 0.2 at 10, 0.32 at
// 150 degrees.
constexpr double kScale_rad = 0.25 * kRadiansPerDegree;
constexpr double kLogarithmic = 25.0;
constexpr double kLinear_per_rad = 3.0 * kDegreesPerRadian;

double coordinate(double angle) {
  return kLogarithmic * std::log1p(angle / kScale_rad) + kLinear_per_rad * angle;
}

std::size_t grid_size() { return static_cast<std::size_t>(std::ceil(coordinate(kPi))) + 1; }

// Step of u between nodes, so that the last is at π.
double grid_step() { return coordinate(kPi) / static_cast<double>(grid_size() - 1); }

std::vector<double> cosines_of_grid() {
  std::vector<double> cosines;
  double angle = 0.0;
  for (std::size_t i = 0; i < grid_size(); ++i) {
    const double wanted = static_cast<double>(i) * grid_step();
    for (int newton = 0; newton < 50; ++newton) {
      const double slope = kLogarithmic / (kScale_rad + angle) + kLinear_per_rad;
      const double step = (wanted - coordinate(angle)) / slope;
      angle += step;
      if (std::abs(step) < 1e-15) break;
    }
    cosines.push_back(std::cos(angle));
  }
  cosines.back() = -1.0;
  return cosines;
}

// Σ (2l+1) χ_l P_l(μ). A tile of angles together, because the recurrence by itself waits for its own results.
std::vector<double> series(const std::vector<double>& moments, const std::vector<double>& mu) {
  constexpr std::size_t kTile = 16;
  std::vector<double> values;
  for (std::size_t first = 0; first < mu.size(); first += kTile) {
    std::array<double, kTile> x{};
    for (std::size_t i = 0; i < kTile && first + i < mu.size(); ++i) x[i] = mu[first + i];
    std::array<double, kTile> sum{};
    std::array<double, kTile> before{};
    std::array<double, kTile> legendre;
    legendre.fill(1.0);
    for (std::size_t l = 0; l < moments.size(); ++l) {
      const double weight = (2.0 * static_cast<double>(l) + 1.0) * moments[l];
      const double part = 1.0 / (static_cast<double>(l) + 1.0);
      for (std::size_t i = 0; i < kTile; ++i) {
        sum[i] += weight * legendre[i];
        const double next = (2.0 - part) * x[i] * legendre[i] - (1.0 - part) * before[i];
        before[i] = legendre[i];
        legendre[i] = next;
      }
    }
    for (std::size_t i = 0; i < kTile && first + i < mu.size(); ++i) values.push_back(sum[i]);
  }
  return values;
}

}  // namespace

TabulatedPhaseFunction::TabulatedPhaseFunction(std::vector<double> moments)
    : moments_(std::move(moments)), table_(series(moments_, cosines_of_grid())) {}

TabulatedPhaseFunction::TabulatedPhaseFunction(const TabulatedPhaseFunction& first,
                                               const TabulatedPhaseFunction& second, double part) {
  moments_.resize(std::max(first.moments_.size(), second.moments_.size()));
  for (std::size_t l = 0; l < moments_.size(); ++l)
    moments_[l] =
        (1.0 - part) * first.moment(static_cast<int>(l)) + part * second.moment(static_cast<int>(l));
  for (std::size_t i = 0; i < first.table_.size(); ++i)
    table_.push_back((1.0 - part) * first.table_[i] + part * second.table_[i]);
}

double TabulatedPhaseFunction::value(double mu) const {
  static const double steps_per_unit = 1.0 / grid_step();
  // 2 atan(√((1-μ)/(1+μ))): accurate towards both ends.
  const double angle =
      2.0 * std::atan2(std::sqrt(std::max(0.0, 1.0 - mu)), std::sqrt(std::max(0.0, 1.0 + mu)));
  const double position = steps_per_unit * coordinate(angle);
  const auto below =
      static_cast<std::size_t>(std::clamp(position, 1.0, static_cast<double>(table_.size() - 3)));
  // Lagrange's cubic through four nodes.
  const double t = position - static_cast<double>(below);
  const double* const p = &table_[below];
  return p[-1] * (-t * (t - 1.0) * (t - 2.0) / 6.0) + p[0] * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0) +
         p[1] * (-(t + 1.0) * t * (t - 2.0) / 2.0) + p[2] * ((t + 1.0) * t * (t - 1.0) / 6.0);
}

double TabulatedPhaseFunction::moment(int l) const {
  const auto order = static_cast<std::size_t>(l);
  return order < moments_.size() ? moments_[order] : 0.0;
}

}  // namespace skylut
