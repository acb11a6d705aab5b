#include "angular_sum.hpp"

#include <array>
#include <cmath>

#include "polarised_tile.hpp"
#include "skylut/core/legendre.hpp"

namespace skylut {

namespace {

// Angles that are summed together: their sums stay in the fastest cache.
constexpr std::size_t kTile = PolarisedTile::kSize;
// Largest over smallest number of terms in a class.
constexpr double kClassRatio = 1.4;

using Complex = std::complex<double>;
using Tile = PolarisedTile::Tile;

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

/// Elements of the matrix at a tile of angles, summed over spheres; F22 is F11.
struct Light {
  Tile f11{};
  Tile f12{};
  Tile f33{};
};

void add_element(Light& light, std::size_t i, double weight, double s1, double s2) {
  light.f11[i] += weight * (square(s1) + square(s2));
  light.f12[i] += weight * (square(s2) - square(s1));
  light.f33[i] += weight * 2.0 * s1 * s2;
}

/// The light that a sphere scatters at μ and at -μ from its sums over odd and even n:
/// π_n(-μ) = (-1)^(n+1) π_n(μ), τ_n(-μ) = (-1)^n τ_n(μ).
void add_light(const std::array<Tile, 8>& odd, const std::array<Tile, 8>& even, double weight, Light& forward,
               Light& backward) {
  for (std::size_t part : {std::size_t{0}, std::size_t{2}})  // real, imaginary
    for (std::size_t i = 0; i < kTile; ++i) {
      const std::size_t a_pi = part;
      const std::size_t a_tau = part + 1;
      const std::size_t b_pi = part + 4;
      const std::size_t b_tau = part + 5;
      add_element(forward, i, weight, odd[a_pi][i] + even[a_pi][i] + odd[b_tau][i] + even[b_tau][i],
                  odd[a_tau][i] + even[a_tau][i] + odd[b_pi][i] + even[b_pi][i]);
      add_element(backward, i, weight, odd[a_pi][i] - even[a_pi][i] - odd[b_tau][i] + even[b_tau][i],
                  even[a_tau][i] - odd[a_tau][i] + odd[b_pi][i] - even[b_pi][i]);
    }
}

/// P_l is even or odd as l is.
void add_phase_moments(const Tile& mu, const Tile& weight, const Tile& forward, const Tile& backward,
                       std::size_t degrees, std::vector<MatrixMoments>& moments) {
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
    moments[l].alpha1 += sum;
  }
}

/// d^l_02(-μ) = (-1)^l d^l_02(μ), d^l_22(-μ) = (-1)^l d^l_2,-2(μ).
void add_polarised_moments(const Tile& mu, const Tile& weight, const Light& forward, const Light& backward,
                           std::size_t degrees, std::vector<MatrixMoments>& moments) {
  Tile polarising_even;
  Tile polarising_odd;
  Tile forward_sum;  // F22 + F33 at μ
  Tile forward_difference;
  Tile backward_sum;
  Tile backward_difference;
  for (std::size_t i = 0; i < kTile; ++i) {
    const double half = 0.5 * weight[i];
    polarising_even[i] = half * (forward.f12[i] + backward.f12[i]);
    polarising_odd[i] = half * (forward.f12[i] - backward.f12[i]);
    forward_sum[i] = half * (forward.f11[i] + forward.f33[i]);
    forward_difference[i] = half * (forward.f11[i] - forward.f33[i]);
    backward_sum[i] = half * (backward.f11[i] + backward.f33[i]);
    backward_difference[i] = half * (backward.f11[i] - backward.f33[i]);
  }
  PolarisedTile functions(mu);
  for (std::size_t l = 2; l < degrees; ++l) {
    const double sign = l % 2 == 0 ? 1.0 : -1.0;
    const Tile& polarising = l % 2 == 0 ? polarising_even : polarising_odd;
    double beta = 0.0;
    double sum = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < kTile; ++i) {
      beta += polarising[i] * functions.polarising[i];
      sum += forward_sum[i] * functions.same[i] + sign * backward_sum[i] * functions.opposite[i];
      difference +=
          forward_difference[i] * functions.opposite[i] + sign * backward_difference[i] * functions.same[i];
    }
    moments[l].beta1 += beta;
    moments[l].alpha2 += 0.5 * (sum + difference);
    moments[l].alpha3 += 0.5 * (sum - difference);
    functions.advance(l);
  }
}

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

std::vector<MatrixMoments> AngularSum::moments(const Rules& rules) const {
  std::vector<MatrixMoments> moments;
  for (const auto& [terms, spheres] : classes_) {
    const Quadrature& rule = rules.at(terms);
    const std::size_t nodes = rule.node.size();
    const std::size_t degrees = 2 * static_cast<std::size_t>(terms) + 1;
    if (moments.size() < degrees) moments.resize(degrees);
    // Nodes with μ > 0, from the forward direction on; each stands for -μ too.
    for (std::size_t first = 0; first < nodes / 2; first += kTile) {
      Tile mu{};
      Tile weight{};
      for (std::size_t i = 0; i < kTile && first + i < nodes / 2; ++i) {
        mu[i] = rule.node[nodes - 1 - (first + i)];
        weight[i] = rule.weight[nodes - 1 - (first + i)];
      }
      const AngularFunctions functions = angular_functions(mu, static_cast<std::size_t>(terms));
      Light forward;
      Light backward;
      for (const WeightedSphere& sphere : spheres)
        add_light(sum_of_every_other(functions, sphere.a, sphere.b, 0),
                  sum_of_every_other(functions, sphere.a, sphere.b, 1), sphere.weight, forward, backward);
      add_phase_moments(mu, weight, forward.f11, backward.f11, degrees, moments);
      add_polarised_moments(mu, weight, forward, backward, degrees, moments);
    }
  }
  return moments;
}

}  // namespace skylut
