#include "angular_sum.hpp"

#include <array>
#include <cmath>

#include "skylut/core/legendre.hpp"

namespace skylut {

namespace {

// Angles that are summed together: their sums stay in the fastest cache.
constexpr std::size_t kTile = 16;
// Largest over smallest number of terms in a class.
constexpr double kClassRatio = 1.4;

using Complex = std::complex<double>;
using Tile = std::array<double, kTile>;

// Angular functions of a tile times (2n+1)/(n(n+1)) for n = 1 … terms. [P4]
struct AngularFunctions {
  std::vector<Tile> pi;
  std::vector<Tile> tau;
};

AngularFunctions angular_functions(const Tile& mu, std::size_t terms) {
  AngularFunctions functions{std::vector<Tile>(terms), std::vector<Tile>(terms)};
  Tile before{};
  Tile pi;
  pi.fill(1.0);
  for (std::size_t index = 0; index < terms; ++index) {
    const double n = static_cast<double>(index) + 1.0;
    const double scale = (2.0 * n + 1.0) / (n * (n + 1.0));
    const double slope = (2.0 * n + 1.0) / n;
    const double drop = (n + 1.0) / n;
    for (std::size_t i = 0; i < kTile; ++i) {
      functions.pi[index][i] = scale * pi[i];
      functions.tau[index][i] = scale * (n * mu[i] * pi[i] - (n + 1.0) * before[i]);
      const double next = slope * mu[i] * pi[i] - drop * before[i];
      before[i] = pi[i];
      pi[i] = next;
    }
  }
  return functions;
}

// Two angles at a time: one register of the smallest instruction set (GCC vector extension).
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

// Σ a π, a τ, b π, b τ over n = first, first + 2, …: real and imaginary part of each. The sums of a pair
// of angles stay in registers.
std::array<Tile, 8> sum_of_every_other(const AngularFunctions& functions, const std::vector<Complex>& a,
                                       const std::vector<Complex>& b, std::size_t first) {
  std::array<Tile, 8> sum;
  for (std::size_t i = 0; i < kTile; i += 2) {
    Pair total[8] = {};
    for (std::size_t index = first; index < a.size(); index += 2) {
      const Pair pi{functions.pi[index][i], functions.pi[index][i + 1]};
      const Pair tau{functions.tau[index][i], functions.tau[index][i + 1]};
      total[0] += a[index].real() * pi;
      total[1] += a[index].real() * tau;
      total[2] += a[index].imag() * pi;
      total[3] += a[index].imag() * tau;
      total[4] += b[index].real() * pi;
      total[5] += b[index].real() * tau;
      total[6] += b[index].imag() * pi;
      total[7] += b[index].imag() * tau;
    }
    for (std::size_t k = 0; k < 8; ++k) {
      sum[k][i] = total[k][0];
      sum[k][i + 1] = total[k][1];
    }
  }
  return sum;
}

double square(double x) { return x * x; }

}  // namespace

int AngularSum::class_of(int terms) {
  int size = 8;
  while (size < terms) size = static_cast<int>(std::ceil(kClassRatio * size));
  return size;
}

void AngularSum::prepare(Rules& rules, int class_terms) {
  // Degree 2 N of the sum times degree 2 N of the polynomial: 2 N + 1 nodes, here 2 N + 2.
  if (!rules.contains(class_terms))
    rules.emplace(class_terms, gauss_legendre(2 * (class_terms + 1), -1.0, 1.0));
}

void AngularSum::add(const MieSphere& sphere, double weight) {
  classes_[class_of(static_cast<int>(sphere.a().size()))].push_back({sphere.a(), sphere.b(), weight});
}

std::vector<double> AngularSum::moments(const Rules& rules) const {
  std::vector<double> moments;
  for (const auto& [terms, spheres] : classes_) {
    const Quadrature& rule = rules.at(terms);
    const std::size_t nodes = rule.node.size();
    const std::size_t degrees = 2 * static_cast<std::size_t>(terms) + 1;
    if (moments.size() < degrees) moments.resize(degrees, 0.0);
    // Nodes with μ > 0, from the forward direction on; each stands for -μ too.
    for (std::size_t first = 0; first < nodes / 2; first += kTile) {
      Tile mu{};
      Tile weight{};
      for (std::size_t i = 0; i < kTile && first + i < nodes / 2; ++i) {
        mu[i] = rule.node[nodes - 1 - (first + i)];
        weight[i] = rule.weight[nodes - 1 - (first + i)];
      }
      const AngularFunctions functions = angular_functions(mu, static_cast<std::size_t>(terms));
      // The scattered light at μ and at -μ: π_n(-μ) = (-1)^(n+1) π_n(μ), τ_n(-μ) = (-1)^n τ_n(μ).
      Tile forward{};
      Tile backward{};
      for (const WeightedSphere& sphere : spheres) {
        const std::array<Tile, 8> odd = sum_of_every_other(functions, sphere.a, sphere.b, 0);
        const std::array<Tile, 8> even = sum_of_every_other(functions, sphere.a, sphere.b, 1);
        for (std::size_t part : {std::size_t{0}, std::size_t{2}})  // real, imaginary
          for (std::size_t i = 0; i < kTile; ++i) {
            const std::size_t a_pi = part;
            const std::size_t a_tau = part + 1;
            const std::size_t b_pi = part + 4;
            const std::size_t b_tau = part + 5;
            forward[i] +=
                sphere.weight * (square(odd[a_pi][i] + even[a_pi][i] + odd[b_tau][i] + even[b_tau][i]) +
                                 square(odd[a_tau][i] + even[a_tau][i] + odd[b_pi][i] + even[b_pi][i]));
            backward[i] +=
                sphere.weight * (square(odd[a_pi][i] - even[a_pi][i] - odd[b_tau][i] + even[b_tau][i]) +
                                 square(even[a_tau][i] - odd[a_tau][i] + odd[b_pi][i] - even[b_pi][i]));
          }
      }
      // P_l is even or odd as l is.
      Tile even_part;
      Tile odd_part;
      Tile before{};
      Tile legendre;
      legendre.fill(1.0);
      for (std::size_t i = 0; i < kTile; ++i) {
        even_part[i] = 0.5 * weight[i] * (forward[i] + backward[i]);
        odd_part[i] = 0.5 * weight[i] * (forward[i] - backward[i]);
      }
      for (std::size_t l = 0; l < degrees; ++l) {
        const Tile& light = l % 2 == 0 ? even_part : odd_part;
        const double part = 1.0 / (static_cast<double>(l) + 1.0);
        double sum = 0.0;
        for (std::size_t i = 0; i < kTile; ++i) {
          sum += light[i] * legendre[i];
          const double next = next_legendre(part, mu[i], legendre[i], before[i]);
          before[i] = legendre[i];
          legendre[i] = next;
        }
        moments[l] += sum;
      }
    }
  }
  return moments;
}

}  // namespace skylut
