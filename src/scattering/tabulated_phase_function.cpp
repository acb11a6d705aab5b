#include "skylut/scattering/tabulated_phase_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "polarised_tile.hpp"
#include "skylut/core/check.hpp"
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

// F12 and F33 of the series at the cosines.
void tabulate_polarisation(const PolarisationMoments& moments, const std::vector<double>& mu,
                           std::vector<double>& f12, std::vector<double>& f33) {
  constexpr std::size_t kTile = PolarisedTile::kSize;
  for (std::size_t first = 0; first < mu.size(); first += kTile) {
    PolarisedTile::Tile x{};
    for (std::size_t i = 0; i < kTile && first + i < mu.size(); ++i) x[i] = mu[first + i];
    PolarisedTile::Tile polarised{};
    PolarisedTile::Tile third{};
    PolarisedTile functions(x);
    for (std::size_t l = 2; l < moments.beta1.size(); ++l) {
      const double weight = 2.0 * static_cast<double>(l) + 1.0;
      const double beta = weight * moments.beta1[l];
      const double sum = 0.5 * weight * (moments.alpha2[l] + moments.alpha3[l]);
      const double difference = 0.5 * weight * (moments.alpha2[l] - moments.alpha3[l]);
      for (std::size_t i = 0; i < kTile; ++i) {
        polarised[i] += beta * functions.polarising[i];
        third[i] += sum * functions.same[i] - difference * functions.opposite[i];
      }
      functions.advance(l);
    }
    for (std::size_t i = 0; i < kTile && first + i < mu.size(); ++i) {
      f12.push_back(polarised[i]);
      f33.push_back(third[i]);
    }
  }
}

// (1 - part) first + part second, 0 beyond the shorter's end.
std::vector<double> mixed(const std::vector<double>& first, const std::vector<double>& second, double part) {
  std::vector<double> values(std::max(first.size(), second.size()));
  for (std::size_t i = 0; i < first.size(); ++i) values[i] += (1.0 - part) * first[i];
  for (std::size_t i = 0; i < second.size(); ++i) values[i] += part * second[i];
  return values;
}

// Where a cosine lies on the grid.
class Place {
 public:
  explicit Place(double mu) {
    const double position = kSteps_per_unit * coordinate(mu);
    below_ = static_cast<std::size_t>(std::clamp(position, 1.0, static_cast<double>(kGridSize - 3)));
    weight_ = cubic_weights(position - static_cast<double>(below_));
  }
  double of(const std::vector<double>& table) const {
    const double* const p = &table[below_ - 1];
    return p[0] * weight_[0] + p[1] * weight_[1] + p[2] * weight_[2] + p[3] * weight_[3];
  }

 private:
  std::size_t below_;
  std::array<double, 4> weight_;
};

}  // namespace

TabulatedPhaseFunction::TabulatedPhaseFunction(std::vector<double> moments)
    : moments_(std::move(moments)), table_(series(moments_, cosines_of_grid())) {}

TabulatedPhaseFunction::TabulatedPhaseFunction(std::vector<double> moments, PolarisationMoments polarisation)
    : TabulatedPhaseFunction(std::move(moments)) {
  SKYLUT_CHECK_EQ(polarisation.alpha2.size(), moments_.size());
  SKYLUT_CHECK_EQ(polarisation.alpha3.size(), moments_.size());
  SKYLUT_CHECK_EQ(polarisation.beta1.size(), moments_.size());
  polarisation_ = std::move(polarisation);
  tabulate_polarisation(polarisation_, cosines_of_grid(), f12_, f33_);
}

TabulatedPhaseFunction::TabulatedPhaseFunction(const TabulatedPhaseFunction& first,
                                               const TabulatedPhaseFunction& second, double part) {
  moments_.resize(std::max(first.moments_.size(), second.moments_.size()));
  for (std::size_t l = 0; l < moments_.size(); ++l)
    moments_[l] =
        (1.0 - part) * first.moment(static_cast<int>(l)) + part * second.moment(static_cast<int>(l));
  for (std::size_t i = 0; i < first.table_.size(); ++i)
    table_.push_back((1.0 - part) * first.table_[i] + part * second.table_[i]);
  if (first.f12_.empty() || second.f12_.empty()) return;
  polarisation_ = {mixed(first.polarisation_.alpha2, second.polarisation_.alpha2, part),
                   mixed(first.polarisation_.alpha3, second.polarisation_.alpha3, part),
                   mixed(first.polarisation_.beta1, second.polarisation_.beta1, part)};
  f12_ = mixed(first.f12_, second.f12_, part);
  f33_ = mixed(first.f33_, second.f33_, part);
}

double TabulatedPhaseFunction::value(double mu) const { return Place(mu).of(table_); }

double TabulatedPhaseFunction::moment(int l) const {
  const auto order = static_cast<std::size_t>(l);
  return order < moments_.size() ? moments_[order] : 0.0;
}

ScatteringMatrix TabulatedPhaseFunction::matrix(double mu) const {
  if (f12_.empty()) return PhaseFunction::matrix(mu);
  const Place place(mu);
  const double f11 = place.of(table_);
  return {f11, place.of(f12_), f11, place.of(f33_)};
}

std::vector<MatrixMoments> TabulatedPhaseFunction::matrix_moments(int max_l) const {
  if (f12_.empty()) return PhaseFunction::matrix_moments(max_l);
  std::vector<MatrixMoments> moments(static_cast<std::size_t>(max_l + 1));
  for (std::size_t l = 0; l < std::min(moments.size(), moments_.size()); ++l)
    moments[l] = {moments_[l], polarisation_.alpha2[l], polarisation_.alpha3[l], polarisation_.beta1[l]};
  return moments;
}

}  // namespace skylut
