#include "skylut/atmosphere/exponential_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace skylut {

namespace {

// What the transmittance of m vertical amounts may be off: 0.005 (1 + m / 2). Most of the sky is seen by
// paths of one to a few vertical amounts; along the horizon scattering hides the far end of the path.
constexpr double kTolerance = 0.005;
constexpr double kTolerancePath = 2.0;
// A third term is worth its cost only where two are far off.
constexpr double kWorthAThird = 2.0;

// Paths to fit, in vertical amounts: from the thin air above a high observer to the horizon.
constexpr double kShortest = 0.05;
constexpr double kLongest = 40.0;
constexpr std::size_t kPaths = 16;
using Curve = std::array<double, kPaths>;

// The largest vertical depth of a term. Blacker ones would cost the solver many thin layers and tell no more:
// at the ground they are black already, and thin air above fits as well (differences below 0.04).
constexpr double kBlackest = 3.0;

// Coefficients to choose from: 0 (the gaps between lines) and steps of a constant ratio.
constexpr std::size_t kSteps = 40;

double path(std::size_t i) {
  return kShortest * std::pow(kLongest / kShortest, static_cast<double>(i) / static_cast<double>(kPaths - 1));
}

// Transmittances along the paths, each in units of what it may be off: equal differences matter equally.
Curve curve_of(const std::vector<Exponential>& sum, double vertical_amount) {
  Curve curve;
  for (std::size_t i = 0; i < kPaths; ++i)
    curve[i] =
        transmittance(sum, vertical_amount * path(i)) / (kTolerance * (1.0 + path(i) / kTolerancePath));
  return curve;
}

double dot(const Curve& a, const Curve& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kPaths; ++i) sum += a[i] * b[i];
  return sum;
}

double largest_difference(const Curve& a, const Curve& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < kPaths; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The exponentials to choose from, their curves and all scalar products: least squares needs no more.
class Candidates {
 public:
  Candidates(double vertical_amount, double weakest, double strongest, const Curve& target) {
    coefficient_.push_back(0.0);
    for (std::size_t i = 0; i < kSteps; ++i)
      coefficient_.push_back(
          weakest * std::pow(strongest / weakest, static_cast<double>(i) / static_cast<double>(kSteps - 1)));
    std::vector<Curve> curves;
    for (double coefficient : coefficient_) curves.push_back(curve_of({{1.0, coefficient}}, vertical_amount));
    target_target_ = dot(target, target);
    for (std::size_t i = 0; i < size(); ++i) {
      with_target_.push_back(dot(curves[i], target));
      for (std::size_t j = 0; j < size(); ++j) product_.push_back(dot(curves[i], curves[j]));
    }
  }

  std::size_t size() const { return coefficient_.size(); }
  double coefficient(std::size_t i) const { return coefficient_[i]; }

  // <e_i - e_k, e_j - e_k> and <e_i - e_k, target - e_k>.
  double product(std::size_t i, std::size_t j, std::size_t k) const {
    return at(i, j) - at(i, k) - at(j, k) + at(k, k);
  }
  double with_target(std::size_t i, std::size_t k) const {
    return with_target_[i] - with_target_[k] - at(i, k) + at(k, k);
  }
  // |target - e_k|².
  double square(std::size_t k) const { return target_target_ - 2.0 * with_target_[k] + at(k, k); }

 private:
  double at(std::size_t i, std::size_t j) const { return product_[i * size() + j]; }

  std::vector<double> coefficient_;
  std::vector<double> with_target_;
  std::vector<double> product_;
  double target_target_ = 0.0;
};

struct Choice {
  double square = 1e300;  // sum of squared differences
  std::vector<Exponential> sum;
};

Choice best_of_one(const Candidates& candidates) {
  Choice best;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (candidates.square(k) < best.square) best = {candidates.square(k), {{1.0, candidates.coefficient(k)}}};
  return best;
}

// w e_i + (1 - w) e_k.
Choice best_of_two(const Candidates& candidates) {
  Choice best;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      const double weight = candidates.with_target(i, k) / candidates.product(i, i, k);
      if (!(weight > 0.0 && weight < 1.0)) continue;
      const double square = candidates.square(k) - weight * candidates.with_target(i, k);
      if (square < best.square)
        best = {square, {{weight, candidates.coefficient(i)}, {1.0 - weight, candidates.coefficient(k)}}};
    }
  return best;
}

// a e_i + b e_j + (1 - a - b) e_k: the normal equations of two unknowns.
Choice best_of_three(const Candidates& candidates) {
  Choice best;
  for (std::size_t k = 2; k < candidates.size(); ++k)
    for (std::size_t i = 0; i + 1 < k; ++i) {
      const double ii = candidates.product(i, i, k);
      const double ti = candidates.with_target(i, k);
      for (std::size_t j = i + 1; j < k; ++j) {
        const double ij = candidates.product(i, j, k);
        const double jj = candidates.product(j, j, k);
        const double tj = candidates.with_target(j, k);
        const double determinant = ii * jj - ij * ij;
        if (!(determinant > 1e-12 * ii * jj)) continue;
        const double a = (ti * jj - tj * ij) / determinant;
        const double b = (tj * ii - ti * ij) / determinant;
        if (!(a > 0.0 && b > 0.0 && a + b < 1.0)) continue;
        const double square = candidates.square(k) - a * ti - b * tj;
        if (square < best.square)
          best = {square,
                  {{a, candidates.coefficient(i)},
                   {b, candidates.coefficient(j)},
                   {1.0 - a - b, candidates.coefficient(k)}}};
      }
    }
  return best;
}

}  // namespace

double transmittance(const std::vector<Exponential>& sum, double amount) {
  double result = 0.0;
  for (const Exponential& term : sum) result += term.weight * std::exp(-term.coefficient * amount);
  return result;
}

std::vector<Exponential> fit_exponentials(const std::vector<Exponential>& sum, double vertical_amount) {
  double mean = 0.0;
  double strongest = 0.0;
  for (const Exponential& term : sum) {
    mean += term.weight * term.coefficient;
    strongest = std::max(strongest, term.coefficient);
  }
  if (!(mean * vertical_amount > 0.0)) return {{1.0, mean}};

  const Curve target = curve_of(sum, vertical_amount);
  // What the longest path does not see is the 0.
  const double upper = std::min(strongest, kBlackest / vertical_amount);
  const double lower = std::min(0.01 / (kLongest * vertical_amount), 0.01 * upper);
  const Candidates candidates(vertical_amount, lower, upper, target);
  const auto off = [&](const Choice& choice) {
    return largest_difference(curve_of(choice.sum, vertical_amount), target);
  };
  Choice best = best_of_one(candidates);
  if (off(best) > 1.0) {
    if (Choice two = best_of_two(candidates); two.square < best.square) best = std::move(two);
    if (off(best) > kWorthAThird)
      if (Choice three = best_of_three(candidates); three.square < best.square) best = std::move(three);
  }
  return best.sum;
}

}  // namespace skylut
