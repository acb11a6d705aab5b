#include "skylut/scattering/tabulated_phase_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "skylut/core/interpolation.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut {

namespace {

// The grid is equally spaced in u = √sin(θ/2) + 0.6 (1 - cos(θ/2)), which takes square roots of μ alone:
// steps of 0.01 degrees at 0.1, 0.04 at 1, 0.1 at 10, 0.3 degrees at 180.
constexpr double kBackward = 0.6;
constexpr std::size_t kGridSize = 1000;
constexpr double kSteps_per_unit = static_cast<double>(kGridSize - 1) / (1.0 + kBackward);

double coordinate(double mu) {
  const double sine = std::sqrt(std::max(0.0, 0.5 * (1.0 - mu)));
  const double cosine = std::sqrt(std::max(0.0, 0.5 * (1.0 + mu)));
  return std::sqrt(sine) + kBackward * (1.0 - cosine);
}

std::vector<double> cosines_of_grid() {
  std::vector<double> cosines{1.0};
  for (std::size_t i = 1; i + 1 < kGridSize; ++i) {
    const double wanted = static_cast<double>(i) / kSteps_per_unit;
    // By bisection in r = √sin(θ/2), in which u grows steadily: μ = 1 - 2 r⁴.
    double low = 0.0;
    double high = 1.0;
    for (int halving = 0; halving < 60; ++halving) {
      const double r = 0.5 * (low + high);
      (coordinate(1.0 - 2.0 * r * r * r * r) < wanted ? low : high) = r;
    }
    cosines.push_back(1.0 - 2.0 * low * low * low * low);
  }
  cosines.push_back(-1.0);
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
        const double next = next_legendre(part, x[i], legendre[i], before[i]);
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
  const double position = kSteps_per_unit * coordinate(mu);
  const auto below =
      static_cast<std::size_t>(std::clamp(position, 1.0, static_cast<double>(table_.size() - 3)));
  const std::array<double, 4> weight = cubic_weights(position - static_cast<double>(below));
  const double* const p = &table_[below - 1];
  return p[0] * weight[0] + p[1] * weight[1] + p[2] * weight[2] + p[3] * weight[3];
}

double TabulatedPhaseFunction::moment(int l) const {
  const auto order = static_cast<std::size_t>(l);
  return order < moments_.size() ? moments_[order] : 0.0;
}

}  // namespace skylut
